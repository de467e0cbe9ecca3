#pragma once
// Is the initial state one that the motion can start from? Emitted code takes it as it is.

#include <vector>

#include "model_values.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// A velocity constraint (3.1) that does not hold.
struct Violation {
  std::size_t index = 0;  ///< into Model::constraints
  const kinematics::ConstraintRow* row = nullptr;
  cln::cl_F residual;  ///< φ_μ, not zero
};

/// At the state that is bound in `values`. Rates that a user copied from a double satisfy a constraint.
std::vector<Violation> violations(const Mechanics& mechanics, ModelValues& values);

/// Warns where the initial state of the model violates a constraint, has no value, or makes the mass matrix singular.
void check_initial_state(Mechanics& mechanics, support::Diagnostics& diagnostics);

}  // namespace gaussgen
