#pragma once
// How large an expression can be in any configuration.

#include <optional>

#include "ir/expr.hpp"

namespace gaussgen::strategy {

/// Of parameters and numbers alone, not less than |e| whatever coordinates are: a sum by its terms, a product by its factors, a sine or cosine
/// by 1. Nothing where e has no such bound, as with a length that changes.
std::optional<ir::Expr> bound_of(ir::Expr e);

/// Whether it is a number, whatever its form.
bool is_number(ir::Expr e);

}  // namespace gaussgen::strategy
