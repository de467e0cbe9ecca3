#pragma once
// Whether the words of a scene, and those of options that take their place, go together.

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// What no model changes: a method, and the number type, projection and engine that it is to work with. Told at a place in the scene, and with it what is not
/// used; throws cli::UsageError where options alone are wrong. Returns what options say and nothing uses.
std::vector<std::string> check_choices(const Scene& scene, gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
