#pragma once
// Which expressions of a model have no value at a state, or no derivative that the equations need.

#include "model_values.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

struct UndefinedPart {
  support::Span span;  ///< the innermost part of the expression that is undefined
  std::string reason;
};

/// Expressions without a value, or without the derivative along the motion that is asked for, at what is bound in `values`; what
/// merely uses a symbol that is not bound does not count.
std::vector<UndefinedPart> undefined_parts(Mechanics& mechanics, ModelValues& values, int derivative = 0);

}  // namespace gaussgen
