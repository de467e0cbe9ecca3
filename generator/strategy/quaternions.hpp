#pragma once

#include "kinematics/symbols.hpp"
#include "strategy/ldl.hpp"

namespace gaussgen::strategy {

/// e·e of each quaternion in `configuration`, in the order of the model's orientations.
Vector squared_norms(const kinematics::Symbols& symbols, const Vector& configuration);

/// Boolean: some norm is a hundredth off 1. Rotations then are scaled as well, and nothing that follows can be trusted.
/// Integration alone stays far below that.
ir::Expr is_off_unit_length(ir::Graph& graph, const Vector& squared_norms);

/// Boolean: some norm is a million times too large or too small, where squares soon leave the range of float.
ir::Expr is_beyond_scaling(ir::Graph& graph, const Vector& squared_norms);

/// Each quaternion divided by its norm; unnamed values.
void normalise(const kinematics::Symbols& symbols, Vector& configuration);

}  // namespace gaussgen::strategy
