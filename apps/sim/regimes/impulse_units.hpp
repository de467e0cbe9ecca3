#pragma once
// In what the impulses of a table of events are: along a length in N*s, along an angle in N*m*s.

#include <string>

#include "sim/regimes/event.hpp"
#include "sim/regimes/switches.hpp"

namespace gausssim {

/// The head of their column, with the unit where all contacts have one: "impulse [N*s]". Where they have several there is a second column: "impulse,unit".
std::string head_of_impulses(const Switches& switches);

/// What stands below it.
std::string cell_of_impulse(const Event& event, const Switches& switches);

}  // namespace gausssim
