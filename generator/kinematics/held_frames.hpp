#pragma once

#include "kinematics/body_motions.hpp"

namespace gaussgen::kinematics {

/// The frames that held coordinates move against their parents, with x^i free; parents first.
std::vector<HeldFrame> held_frames(const model::Model& model, const Symbols& symbols, Expressions& expressions,
                                   Partials& partials);

}  // namespace gaussgen::kinematics
