#pragma once
// Turns by a fixed angle, of which the axes of other links take care.

#include "kinematics/linkage.hpp"

namespace gaussgen::strategy {

bool has_fixed_turns(const kinematics::Linkage& linkage);

/// Gives links axes in which turns by fixed angles vanish: those of what hangs on such a turn, or of the link before that turns
/// about the same axis. Parts, places and offsets are given in the new axes.
void choose_axes(kinematics::Linkage& linkage);

}  // namespace gaussgen::strategy
