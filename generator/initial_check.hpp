#pragma once
// Is the initial state one that the motion can start from? Emitted code takes it as it is.

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// Warns where the initial state of the model violates a constraint, has no value, makes constraints depend on each other, or
/// makes the mass matrix singular.
void check_initial_state(Mechanics& mechanics, support::Diagnostics& diagnostics);

}  // namespace gaussgen
