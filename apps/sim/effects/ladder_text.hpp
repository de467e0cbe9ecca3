#pragma once
// What effects cost and change, for people.

#include <optional>
#include <string>

#include "sim/effects/ladder.hpp"

namespace gausssim {

/// What is shown of a scene.
struct EffectsReport {
  const Workbench& bench;
  const Ladder& ladder;
  std::optional<double> need;
  std::optional<Measured> chosen;  ///< for `need`
};

std::string in_words(const EffectsReport& report);

/// SVG: for each effect what it costs beside what it changes, and the ladder.
std::string chart_of_effects(const EffectsReport& report);

}  // namespace gausssim
