#pragma once
// Which expressions of a model have no value at a state, or no derivative that the equations need.

#include "model_values.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

struct UndefinedPart {
  support::Span span;  ///< the innermost part of the expression that is undefined
  std::string reason;
  int derivative = 0;  ///< how often it has to be differentiated until it is
};

/// At what is bound in `values`; what merely uses a symbol that is not bound does not count. Expressions that have no value,
/// or, if all have one, those whose first derivative along the motion has none, else those whose second has none.
std::vector<UndefinedPart> undefined_parts(Mechanics& mechanics, ModelValues& values);

}  // namespace gaussgen
