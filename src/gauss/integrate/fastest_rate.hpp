// How fast the fastest part of a motion is, and a stepper that refuses steps which do not resolve it.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_FASTEST_RATE_HPP
#define GAUSS_INTEGRATE_FASTEST_RATE_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/step_result.hpp"
#include "gauss/integrate/unit_groups.hpp"

namespace gauss::integrate {

/// Largest absolute eigenvalue of d rhs/d state, in 1 by the unit of time, to some percent: by powers of the Jacobian on one vector, of which differences
/// of rates are taken (100 evaluations of the model). Infinite where the model has no rates.
template <class Model>
typename Model::Scalar fastest_rate(const Model& model, const typename Model::Scalar& t,
                                    const typename Model::State& state) {
  using Scalar = typename Model::Scalar;
  constexpr int k_powers = 50;
  // Growth of a vector swings between two values where eigenvalues are imaginary: their mean over an even number of powers does not.
  constexpr int k_counted = 30;
  const Scalar reach = std::cbrt(std::numeric_limits<Scalar>::epsilon());
  auto scale = UnitGroups<Model>(model).largest(state);
  // What is 0 with all that has its unit has no scale, and takes part as large as the others make it.
  const Scalar any = *std::max_element(scale.begin(), scale.end());
  if (any == Scalar(0)) scale.fill(Scalar(1));
  Scalar vector[Model::size];
  for (std::size_t i = 0; i < Model::size; ++i)
    vector[i] = (scale[i] > Scalar(0) ? scale[i] : any) * (i % 2 == 0 ? 1 : -1) / static_cast<Scalar>(i + 1);
  Scalar growth = 0;
  for (int power = 0; power < k_powers; ++power) {
    typename Model::State above = state, below = state;
    for (std::size_t i = 0; i < Model::size; ++i) {
      above.values[i] += reach * vector[i];
      below.values[i] -= reach * vector[i];
    }
    typename Model::Derivative high, low;
    if (!is_motion_known(model.derivative(t, above, high)) || !is_motion_known(model.derivative(t, below, low)))
      return std::numeric_limits<Scalar>::infinity();
    Scalar size = 0;
    for (std::size_t i = 0; i < Model::size; ++i) {
      vector[i] = (high.values[i] - low.values[i]) / (2 * reach);
      if (scale[i] > Scalar(0)) size = std::max(size, std::abs(vector[i]) / scale[i]);
    }
    if (!(size > 0)) return 0;
    for (Scalar& component : vector) component /= size;
    if (power >= k_powers - k_counted) growth += std::log(size);
  }
  return std::exp(growth / k_counted);
}

/// Refuses steps for which h times the fastest rate is beyond a limit: an explicit method would lose what is fast, or overflow. Looks before the first step and
/// before each `every` steps.
template <class Inner>
class Resolved {
 public:
  using Scalar = typename Inner::Scalar;
  using State = typename Inner::State;

  /// `limit`: RK4 is stable up to 2.8, and takes 1/144 of an oscillation away in each step at 1.
  explicit Resolved(Inner inner = Inner(), const Scalar& limit = 1, long every = 1000)
      : inner_(std::move(inner)), limit_(limit), every_(every) {}

  template <class Model>
  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    if (steps_ % every_ == 0) {
      rate_ = fastest_rate(model, t, state);
      if (!(std::abs(h) * rate_ <= limit_)) return {StepOutcome::too_long, Status::ok};
    }
    const StepResult result = inner_.step(model, t, h, state);
    if (result.is_taken()) ++steps_;
    return result;
  }

  /// As it was found last.
  const Scalar& rate() const { return rate_; }
  const Inner& inner() const { return inner_; }

 private:
  Inner inner_;
  Scalar limit_;
  Scalar rate_ = 0;
  long every_;
  long steps_ = 0;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_FASTEST_RATE_HPP
