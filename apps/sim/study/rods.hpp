#pragma once
// Rods and ropes: what holds particles together, told from its forces.

#include <set>
#include <string>

#include "sim/study/motion.hpp"

namespace gausssim {

/// Adds a line for each of these constraints that pulls or pushes two particles towards each other, or one of them towards the origin that it goes about, at all times. Up to
/// `rounding` of the largest force; a side that feels less is none.
void add_rods(const std::set<std::string>& constraints, double rounding, Motion& motion);

}  // namespace gausssim
