#pragma once
// Points of constraints that nothing is reported at.

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// Constraints whose force the coordinates do not determine: held coordinates and velocity constraints by name.
std::vector<std::string> constraints_without_force(const Mechanics& mechanics);

/// A warning for every `point` of such a constraint, as no moment about it is emitted.
void check_points(const Mechanics& mechanics, support::Diagnostics& diagnostics);

}  // namespace gaussgen
