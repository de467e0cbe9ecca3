#pragma once

#include "ir/expr.hpp"

namespace gaussgen::ir {

/// A number, and the coefficients of a sum, in at most 352 bits (105 digits; every scalar type has fewer).
///
/// For values that Newton's method has found from numbers alone: exact rationals double their digits in each step, and what is left
/// of a residual halves its exponent, until it leaves the range of every type. Products of two have room in double when they are
/// brought to a common denominator, as the graph does.
Expr rounded(Expr value);

/// A residual, with 0 for numbers that rounding leaves in it: those below 1e-100. Their squares are beyond the range of double.
Expr without_rounding(Expr residual);

}  // namespace gaussgen::ir
