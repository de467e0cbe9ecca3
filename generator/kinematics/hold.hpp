#pragma once

#include "kinematics/kinematics.hpp"

namespace gaussgen::kinematics {

/// Puts x^i = c^i(t), ẋ^i = ċ^i into everything and fills held_acceleration with c̈^i (Vujičić (1.4), theory section 4).
void hold_coordinates(const model::Model& model, Expressions& expressions, ir::Graph& graph, Kinematics& kinematics);

}  // namespace gaussgen::kinematics
