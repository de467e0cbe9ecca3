#pragma once
// Velocity constraints that an initial state violates.

#include <string>
#include <vector>

#include "model_values.hpp"

namespace gaussgen {

/// A constraint (3.1), or an equation of positions, that does not hold.
struct Violation {
  std::size_t index = 0;  ///< into Model::constraints
  const kinematics::ConstraintRow* row = nullptr;
  bool is_of_positions = false;
  cln::cl_F residual;  ///< φ_μ, or f; not zero
};

/// At the state that is bound in `values`. Rates that a user copied from a double satisfy a constraint.
std::vector<Violation> violations(const Mechanics& mechanics, ModelValues& values);

/// What to change so that the constraint holds.
std::string remedy(const Mechanics& mechanics, const Violation& violation, ModelValues& values);

}  // namespace gaussgen
