// A start that satisfies the constraints, from one that almost does; with a report of what moved, and no silence.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_ASSEMBLY_HPP
#define GAUSS_SIMULATE_ASSEMBLY_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "gauss/integrate/step_result.hpp"
#include "gauss/integrate/unit_groups.hpp"

namespace gauss::simulate {

enum class AssemblyOutcome {
  assembled,
  moved_too_far,  ///< a component would have to move by more than the limit
  not_reached,    ///< projection does not converge from here, or the model's status says why it fails
};

constexpr const char* name(AssemblyOutcome outcome) noexcept {
  return outcome == AssemblyOutcome::assembled       ? "assembled"
         : outcome == AssemblyOutcome::moved_too_far ? "moved too far"
                                                     : "not reached";
}

template <class Scalar>
struct Assembly {
  AssemblyOutcome outcome = AssemblyOutcome::not_reached;
  Status status = Status::ok;  ///< of the last projection
  Scalar largest = 0;          ///< move of a component, in its own unit
  std::size_t component = 0;   ///< of the state, which moved so
};

/// Projects `state` until it stays where it is, to rounding. The state is changed only where it is assembled, and then no component has moved
/// by more than `limit`, in its own unit.
template <class Model>
Assembly<typename Model::Scalar> assemble(const Model& model, const typename Model::Scalar& t,
                                          typename Model::State& state, const typename Model::Scalar& limit) {
  using Scalar = typename Model::Scalar;
  constexpr int k_most_projections = 10;
  Assembly<Scalar> result;
  typename Model::State trial = state;
  const integrate::UnitGroups<Model> groups(model);
  bool is_settled = false;
  for (int k = 0; k < k_most_projections && !is_settled; ++k) {
    const typename Model::State before = trial;
    result.status = model.projection(t, trial);
    is_settled = integrate::is_motion_known(result.status);
    const auto sizes = groups.largest(trial);
    for (std::size_t i = 0; i < Model::size; ++i) {
      const Scalar rounding = 64 * std::numeric_limits<Scalar>::epsilon() * sizes[i];
      if (!(std::abs(trial.values[i] - before.values[i]) <= rounding)) is_settled = false;
    }
  }
  for (std::size_t i = 0; i < Model::size; ++i) {
    const Scalar move = std::abs(trial.values[i] - state.values[i]);
    if (move <= result.largest) continue;
    result.largest = move;
    result.component = i;
  }
  if (!is_settled) return result;
  result.outcome = result.largest <= limit ? AssemblyOutcome::assembled : AssemblyOutcome::moved_too_far;
  if (result.outcome == AssemblyOutcome::assembled) state = trial;
  return result;
}

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_ASSEMBLY_HPP
