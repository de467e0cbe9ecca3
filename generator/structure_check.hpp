#pragma once
// What the factorisation found out about a model as a whole, in every configuration.

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// An error for every speed that nothing gives inertia, a warning for every constraint that follows from the others.
void check_structure(const Mechanics& mechanics, support::Diagnostics& diagnostics);

}  // namespace gaussgen
