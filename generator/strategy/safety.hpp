#pragma once
// Which values may be divided by in every configuration (architecture, decision 5).

#include "ir/expr.hpp"

namespace gaussgen::strategy {

/// How sure it is that a pivot cannot vanish; smaller is better.
enum class Safety { number, parameter_monomial, unknown };

Safety safety(ir::Expr pivot);

}  // namespace gaussgen::strategy
