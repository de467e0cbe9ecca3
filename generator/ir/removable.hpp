#pragma once

#include "ir/expr.hpp"

namespace gaussgen::ir {

/// A product such as sin(x)/x, which has a limit at x = 0 and no value there, in a form that has the limit as its value; any other product
/// itself. So do sinh(x)/x, tan(x)/x, (1 - cos x)/x², (cosh x - 1)/x², (x - sin x)/x³, (sin x - x cos x)/x³, also with lower powers and
/// with reciprocals. Their derivatives of any order keep their digits at small x.
///
/// `epsilon` is the rounding unit of the type of a run. At small x they are the first terms of a series: up to 1.4 (differences: 2) in types of
/// up to 20 digits, up to 0.9 in 34 and up to 0.3 in 50. Above that they are in closed form, where a derivative of order n of a
/// difference loses 2 n + 2 times the digits of 1/x.
Expr without_removable_pole(Expr product, Expr epsilon);

}  // namespace gaussgen::ir
