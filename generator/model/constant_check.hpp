#pragma once
// Parts of an expression that hold numbers and pi only and have no real, finite value.

#include "model/ast.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Reports the innermost such part; false when there was one.
bool check_constants(const Ast& ast, support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
