#pragma once

#include <optional>

#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// Whether the file is a scene, which names a model, and not a model itself. False for what is no YAML either: reading it as a model says what is wrong.
bool is_scene(const gaussgen::support::Source& source);

/// What can be read of a file that may have errors; all of them are in `diagnostics`. Nothing of a file that holds no keys.
std::optional<Scene> read_scene(const gaussgen::support::Source& source, gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
