#pragma once
// Whether motions have power series.

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// Errors for functions with a jump or a kink in the equations of motion: a series from one side of it says nothing of the other.
void check_series(const Mechanics& mechanics, support::Diagnostics& diagnostics);

}  // namespace gaussgen
