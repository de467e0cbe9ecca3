#pragma once
// The cheapest setting that delivers an error.

#include <optional>
#include <string>

#include "sim/run/found_setting.hpp"

namespace gausssim {

/// Tries the methods that come into question, each at a loose tolerance that delivers half of the error against a tight run; in more digits where double cannot deliver it;
/// and the cheapest without projection, too, which is taken where keeping the constraints costs a quarter more.
/// A method or number type that the scene names is taken as it is. When time is over, the cheapest of those that were tried counts. Nothing: `why`.
std::optional<FoundSetting> find_setting(const PreparedModel& prepared, Engines& engines, const Wanted& wanted,
                                         std::string& why);

}  // namespace gausssim
