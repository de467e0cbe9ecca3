#pragma once
// Velocity constraints that say together less than their number.

#include <cstddef>
#include <vector>

#include "model_values.hpp"

namespace gaussgen {

/// A constraint whose gradient over the free speeds is a combination of those of constraints before it.
struct Dependence {
  std::size_t index = 0;    ///< into Model::constraints
  bool is_empty = false;    ///< the gradient is zero
  bool everywhere = false;  ///< not at this state only: no form of the expressions shows it, their numbers do
};

/// At the state that is bound in `values`; nothing where a gradient has no value.
std::vector<Dependence> dependences(Mechanics& mechanics, ModelValues& values);

}  // namespace gaussgen
