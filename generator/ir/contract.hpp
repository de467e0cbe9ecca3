#pragma once

#include <utility>
#include <vector>

#include "ir/expr.hpp"
#include "ir/vector3.hpp"

namespace gaussgen::ir {

/// Σ a_i b_i. Small sums are also multiplied out, since J·J and J·h of a chart with angles collapse by sin² + cos² = 1;
/// the cheaper form is taken, so nothing is ever made longer (hard cases, finding 3).
Expr contract(Graph& graph, const std::vector<std::pair<Expr, Expr>>& pairs);

/// a·b by `contract`
Expr dot(const Vector3& a, const Vector3& b);

/// m v
Vector3 multiply(const Matrix3& m, const Vector3& v);

}  // namespace gaussgen::ir
