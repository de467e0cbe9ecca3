#pragma once
// What effects cost and change, for programs and for the page: docs/study-format.md.

#include <nlohmann/json.hpp>
#include <string>

#include "sim/effects/ladder_text.hpp"

namespace gausssim {

nlohmann::ordered_json json_of(const EffectsReport& report);

/// Of a scene with all effects that it calls for, or of a model with all that it has; `why` in it, where nothing is told. Warnings are not said
/// again. Throws Interrupted.
nlohmann::ordered_json json_of_effects(const std::string& file, double seconds);

}  // namespace gausssim
