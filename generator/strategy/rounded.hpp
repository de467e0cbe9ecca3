#pragma once

#include "ir/expr.hpp"

namespace gaussgen::strategy {

/// A number, and the coefficients of a sum, in at most 400 bits (120 digits; every scalar type has fewer).
///
/// For values that Newton's method has found from numbers alone: exact rationals double their digits in each step, and what is left
/// of a residual halves its exponent, until it leaves the range of every type.
ir::Expr rounded(ir::Expr value);

}  // namespace gaussgen::strategy
