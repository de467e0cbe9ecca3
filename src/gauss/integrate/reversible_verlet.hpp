// Verlet's step on a grid: a motion that comes back to the bit, however chaotic it is.
// SPDX-License-Identifier: MIT
//
// A symmetric method goes back the way that it came but for rounding, which a chaotic motion enlarges without limit. Where places and speeds are whole
// multiples of a unit, and what a step adds is rounded to one, sums are exact: a step back takes away what the step has added (Levesque and Verlet, Molecular dynamics and
// time reversibility, Journal of Statistical Physics 72 (1993) 519-537).
#ifndef GAUSS_INTEGRATE_REVERSIBLE_VERLET_HPP
#define GAUSS_INTEGRATE_REVERSIBLE_VERLET_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "gauss/integrate/nystrom_stepper.hpp"

namespace gauss::integrate {

/// Order 2, for accelerations that depend on coordinates alone, as Verlet. The first step moves a start onto the grid, by half a unit at most. A state that
/// leaves the reach is refused (`unsuitable`): beyond it sums would round. So is a motion that is small beside it, whose steps keep less than three tenths of their
/// digits on the grid, of speeds and coordinates alike: it would stand still at last.
template <class Model>
class ReversibleVerlet {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;

  /// No coordinate, and no speed, will be larger, each in its own unit: one in 2^52 of that, or twice as much, is the unit of the grid. The same ones out
  /// and back.
  explicit ReversibleVerlet(const Scalar& reach_of_coordinates = 64, const Scalar& reach_of_speeds = 64)
      : coordinates_(grid(reach_of_coordinates)), speeds_(grid(reach_of_speeds)) {}

  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    if (watch_.is_due() && !watch_.suits(model, t, h, state)) return refused_by_nystrom(model, t, state);
    State trial = state;
    for (std::size_t i = 0; i < Model::n_q; ++i) {
      trial.values[i] = rounded(state.values[i], coordinates_);
      trial.values[Model::n_q + i] = rounded(state.values[Model::n_q + i], speeds_);
    }
    drift(h / 2, trial);
    typename Model::Derivative rates;
    const StepResult result = result_of(model.derivative(t, trial, rates));
    if (!result.is_taken()) return result;
    if (is_lost_on_grid(h, trial, rates)) return {StepOutcome::unsuitable, result.status};
    for (std::size_t i = Model::n_q; i < Model::size; ++i) trial.values[i] += rounded(h * rates.values[i], speeds_);
    drift(h / 2, trial);
    if (!is_within_reach(trial)) return {StepOutcome::unsuitable, result.status};
    watch_.step_taken();
    state = trial;
    return result;
  }

 private:
  /// A power of two, so that multiples of it are exact.
  static Scalar grid(const Scalar& reach) {
    return std::ldexp(Scalar(1), std::ilogb(reach) + 2 - std::numeric_limits<Scalar>::digits);
  }
  static Scalar rounded(const Scalar& value, const Scalar& unit) { return std::nearbyint(value / unit) * unit; }

  void drift(const Scalar& h, State& state) const {
    for (std::size_t i = 0; i < Model::n_q; ++i)
      state.values[i] += rounded(h * state.values[Model::n_q + i], coordinates_);
  }

  bool is_lost_on_grid(const Scalar& h, const State& state, const typename Model::Derivative& rates) const {
    const Scalar least = std::ldexp(Scalar(1), std::numeric_limits<Scalar>::digits * 3 / 10);
    Scalar units = 0;
    for (std::size_t i = 0; i < Model::n_q; ++i) {
      units = std::max(units, std::abs(h * state.values[Model::n_q + i]) / coordinates_);
      units = std::max(units, std::abs(h * rates.values[Model::n_q + i]) / speeds_);
    }
    return units > 0 && units < least;
  }

  bool is_within_reach(const State& state) const {
    const Scalar most = std::ldexp(Scalar(1), std::numeric_limits<Scalar>::digits - 1);
    for (std::size_t i = 0; i < Model::size; ++i)
      if (!(std::abs(state.values[i]) <= most * (i < Model::n_q ? coordinates_ : speeds_))) return false;
    return true;
  }

  Scalar coordinates_, speeds_;
  NystromWatch watch_;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_REVERSIBLE_VERLET_HPP
