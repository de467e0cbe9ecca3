#pragma once
// How many trajectories are integrated together.

#include <string>

#include "cli/messages.hpp"
#include "sim/ensemble/lanes.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/simulate.hpp"

namespace gausssim {

/// `wanted`: "auto" or a number. Without a kernel it is one trajectory after the other, and a remark says why where more were possible otherwise. Throws
/// cli::UsageError where a number is asked for that there is not.
BuiltLanes choose_lanes(const std::string& wanted, const PreparedModel& prepared, const Engine& engine,
                        const Setting& setting, const gaussgen::cli::MessageOptions& messages);

}  // namespace gausssim
