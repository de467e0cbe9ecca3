#pragma once
// What is said of configurations at which the coordinates no longer describe every motion.

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// A warning for every coordinate that makes the chart singular somewhere, with the places and another description.
void check_chart(Mechanics& mechanics, support::Diagnostics& diagnostics);

}  // namespace gaussgen
