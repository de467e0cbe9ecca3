#pragma once

#include <optional>

#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// What can be read of a file that may have errors; all of them are in `diagnostics`. Nothing of a file that holds no keys.
std::optional<Scene> read_scene(const gaussgen::support::Source& source, gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
