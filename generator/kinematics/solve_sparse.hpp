#pragma once

#include <optional>
#include <vector>

#include "ir/expr.hpp"

namespace gaussgen::kinematics {

/// What to do with more than four unknowns that are coupled with each other.
enum class LargeBlocks {
  refuse,
  eliminate,  ///< by L U, with pivots from the diagonal: for matrices of which most is there
};

/// x with matrix x = right, as expressions. Rows with one unknown are solved one after the other; what couples the rest is solved
/// by Cramer's rule, block by block. Nothing where the matrix is singular as it is written, or a large block is refused.
std::optional<std::vector<ir::Expr>> solve_sparse(const std::vector<std::vector<ir::Expr>>& matrix,
                                                  std::vector<ir::Expr> right, LargeBlocks large);

}  // namespace gaussgen::kinematics
