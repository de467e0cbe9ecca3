#pragma once
// How far a displacement goes along each speed before constraints become other ones. Coordinates do not tell: those of a mechanism far off the origin
// are large, those at their zero have no size, and units may be any.

#include <vector>

#include "mechanics.hpp"

namespace gaussgen {

class PositionEquations;

/// In the order of the speeds, at the place where `equations` are: where gradients of constraints, in the metric of inertias, have changed by half of
/// themselves. Angles have a radian at most. What changes no gradient has its own size, or 1, and no less than what else is in its equations.
std::vector<double> spans_at(const Mechanics& mechanics, PositionEquations& equations);

}  // namespace gaussgen
