// What a step of an integrator says, whichever method takes it.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_STEP_RESULT_HPP
#define GAUSS_INTEGRATE_STEP_RESULT_HPP

#include "gauss/math.hpp"

namespace gauss::integrate {

enum class StepOutcome {
  taken,
  model_failed,   ///< the status of the model says why
  not_converged,  ///< the equations of an implicit method were not solved: the step is too long
  unsuitable,     ///< the method does not fit the model
  too_long,       ///< the step does not resolve the fastest part of the motion
};

constexpr const char* name(StepOutcome outcome) noexcept {
  return outcome == StepOutcome::taken           ? "taken"
         : outcome == StepOutcome::model_failed  ? "model failed"
         : outcome == StepOutcome::not_converged ? "not converged"
         : outcome == StepOutcome::too_long      ? "step too long"
                                                 : "unsuitable method";
}

/// `taken` says that the state is that at the end of the step; else the state is the one before it.
struct StepResult {
  StepOutcome outcome = StepOutcome::taken;
  Status status =
      Status::ok;  ///< of the model; where it is not ok, the first one that stopped the step, or a milder one

  constexpr bool is_taken() const noexcept { return outcome == StepOutcome::taken; }
};

/// Where constraints depend on each other, multipliers are not unique but accelerations are: the motion goes on.
constexpr bool is_motion_known(Status status) noexcept {
  return status == Status::ok || status == Status::dependent_constraints;
}

constexpr StepResult result_of(Status status) noexcept {
  return {is_motion_known(status) ? StepOutcome::taken : StepOutcome::model_failed, status};
}

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_STEP_RESULT_HPP
