#pragma once
// Inverses by an unrolled factorisation: no expression is divided into another symbolically.

#include <functional>
#include <string>
#include <vector>

#include "ir/expr.hpp"

namespace gaussgen::lower {

using ExprMatrix = std::vector<std::vector<ir::Expr>>;

/// How the entries of a matrix are called.
struct MatrixNames {
  std::string name;
  std::vector<std::string> rows;
  std::vector<std::string> columns;

  std::string operator()(std::size_t i, std::size_t j) const { return name + "_" + rows[i] + "_" + columns[j]; }
};

/// M^-1 = L^-T D^-1 L^-1 of a symmetric positive definite M = L D Lᵀ, in the order given.
ExprMatrix inverse_by_ldlt(const ExprMatrix& matrix, const MatrixNames& names);

/// Whether an expression is zero in every configuration, though it does not say so. Empty: nobody knows.
using Vanishes = std::function<bool(ir::Expr)>;

/// Gauss–Jordan elimination; pivots are chosen here, by what cannot vanish, not when numbers are known.
ExprMatrix inverse_by_elimination(ExprMatrix matrix, const MatrixNames& names, const Vanishes& vanishes = nullptr);

}  // namespace gaussgen::lower
