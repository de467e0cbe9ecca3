#pragma once

#include <optional>
#include <vector>

#include "ir/expr.hpp"

namespace gaussgen::kinematics {

/// x with matrix x = right, as expressions. Rows with one unknown are solved one after the other; what couples the rest is solved
/// by Cramer's rule, block by block. Nothing where the matrix is singular as it is written, or couples more than four unknowns.
std::optional<std::vector<ir::Expr>> solve_sparse(const std::vector<std::vector<ir::Expr>>& matrix,
                                                  std::vector<ir::Expr> right);

}  // namespace gaussgen::kinematics
