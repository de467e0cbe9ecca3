// Symplectic steps for q'' = a(q): the error of the energy stays bounded, however long the run.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_NYSTROM_STEPPER_HPP
#define GAUSS_INTEGRATE_NYSTROM_STEPPER_HPP

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/base/symplectic_rkn_stepper_base.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <cstddef>
#include <iterator>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/state_arrays.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

/// Whether rates are the speeds, and accelerations those of here, at another time and with other speeds: to the bit.
template <class Model>
bool is_same_elsewhere(const Model& model, const typename Model::Scalar& t, const typename Model::State& state,
                       const typename Model::Derivative& here) {
  using Scalar = typename Model::Scalar;
  using Arrays = StateArrays<Model>;
  const std::size_t n_q = Arrays::n_q(model), size = Arrays::size(model);
  typename Model::State other = state;
  for (std::size_t i = n_q; i < size; ++i)
    other.values[i] = -2 * state.values[i] + Scalar(1) + static_cast<Scalar>(i) / 8;
  auto there = Arrays::rates(model);
  if (!is_motion_known(model.derivative(t, other, there))) return false;
  const auto* const now = std::data(here.values);
  const auto* const then = std::data(there.values);
  return std::equal(now + n_q, now + size, then + n_q) && std::equal(then, then + n_q, std::data(other.values) + n_q);
}

/// What a step of a model that does not suit comes to: its own status where that stops it, else `unsuitable`.
template <class Model>
StepResult refused_by_nystrom(const Model& model, const typename Model::Scalar& t, const typename Model::State& state) {
  auto derivative = StateArrays<Model>::rates(model);
  const StepResult result = result_of(model.derivative(t, state, derivative));
  return result.is_taken() ? StepResult{StepOutcome::unsuitable, result.status} : result;
}

/// Looks from time to time whether rates are the speeds, and accelerations depend neither on speeds nor on time. What is true of one state in general
/// position is true of the model, but for cases (`piecewise`, tables) that do not hold there, and for inputs from a function.
///
/// The first look compares with k_times times ahead, each later one with one of them in turn: it takes two accelerations. They are the golden section of a
/// step, and twice the one before, so they need no unit. A wave of two halves, of any phase, that is the same at all of them has k_times doublings of
/// (golden section of a step)/period within half a turn around 0, hence a whole number there: no ratio of whole numbers is one.
class NystromWatch {
 public:
  static constexpr int k_steps_between = 32;
  static constexpr int k_times = 24;  ///< the last one is 10^7 steps ahead

  bool is_due() const { return steps_ == 0; }
  void step_taken() {
    steps_ = (steps_ + 1) % k_steps_between;
    if (steps_ == 0) looks_ = looks_ % k_times + 1;
  }

  /// At this state, as far as a look of now sees.
  template <class Model>
  bool suits(const Model& model, const typename Model::Scalar& t, const typename Model::Scalar& h,
             const typename Model::State& state) const {
    using Arrays = StateArrays<Model>;
    if (Arrays::size(model) != 2 * Arrays::n_q(model)) return false;
    auto here = Arrays::rates(model);
    if (!is_motion_known(model.derivative(t, state, here))) return false;
    const int first = looks_ == 0 ? 0 : looks_ - 1, end = looks_ == 0 ? k_times : looks_;
    for (int k = first; k < end; ++k) {
      if (!is_same_elsewhere(model, t + steps_ahead<typename Model::Scalar>(k) * h, state, here)) return false;
    }
    return looks_ > 0 || suits_ahead(model, t, k_steps_between * h, state, here);
  }

 private:
  /// A start is in no general position where what depends on speeds is 0 there, as between rods in line: where the motion is about to lead, they are not.
  template <class Model>
  static bool suits_ahead(const Model& model, const typename Model::Scalar& t, const typename Model::Scalar& span,
                          const typename Model::State& state, const typename Model::Derivative& rates) {
    const std::size_t n_q = StateArrays<Model>::n_q(model);
    const auto* const rate = std::data(rates.values);
    const auto* const acceleration = rate + n_q;
    typename Model::State ahead = state;
    for (std::size_t i = 0; i < n_q; ++i) {
      ahead.values[i] += span * (rate[i] + span / 2 * acceleration[i]);
      ahead.values[n_q + i] += span * acceleration[i];
    }
    auto there = StateArrays<Model>::rates(model);
    return !is_motion_known(model.derivative(t, ahead, there)) || is_same_elsewhere(model, t, ahead, there);
  }

  template <class Scalar>
  static Scalar steps_ahead(int k) {
    return Scalar(1.6180339887498949) * static_cast<Scalar>(1L << k);
  }

  int steps_ = 0;  ///< since the last look
  int looks_ = 0;  ///< 0: none yet; else which time ahead is next, from 1
};

/// `Method` is one of Odeint's symplectic Runge-Kutta-Nystrom steppers over arrays of n_q numbers, or has its do_step. The first step looks whether
/// the model suits, and so does each NystromWatch::k_steps_between-th after it, since a damper may begin to act on the way; one that does not suit is refused there. What depends
/// on speeds for fewer steps may pass between two looks: those steps have order 1 and no symmetry.
template <class Model, class Method>
class NystromStepper {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  using Half = typename HalfArrays<Model>::Array;

  // Scratch space of the method has no values to copy before the first step.
  NystromStepper() = default;
  NystromStepper(const NystromStepper& other) : watch_(other.watch_) {}
  NystromStepper& operator=(const NystromStepper& other) {
    watch_ = other.watch_;
    return *this;
  }

  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    if (watch_.is_due() && !watch_.suits(model, t, h, state)) return refused_by_nystrom(model, t, state);
    Half q = HalfArrays<Model>::zeros(model), v = q;
    const std::size_t n_q = q.size();
    std::copy_n(std::data(state.values), n_q, q.begin());
    std::copy_n(std::data(state.values) + n_q, n_q, v.begin());
    Status trouble = Status::ok;
    State at = state;
    auto derivative = StateArrays<Model>::rates(model);
    // Time does not matter: NystromWatch has seen to it.
    const auto acceleration = [&](const Half& position, Half& result) {
      std::copy(position.begin(), position.end(), std::begin(at.values));
      const Status status = model.derivative(t, at, derivative);
      if (is_motion_known(trouble) && status != Status::ok) trouble = status;
      fit(result, n_q);
      std::copy_n(std::data(derivative.values) + n_q, n_q, result.begin());
    };
    method_.do_step(acceleration, q, v, t, h);
    const StepResult result = result_of(trouble);
    if (!result.is_taken()) return result;
    watch_.step_taken();
    std::copy(q.begin(), q.end(), std::data(state.values));
    std::copy(v.begin(), v.end(), std::data(state.values) + n_q);
    return result;
  }

 private:
  Method method_;
  NystromWatch watch_;
};

/// Half a step of positions, one of speeds, half a step of positions. Nothing is kept for the next step, so a state may be corrected between them.
template <class Half, class Scalar>
class PositionVerlet {
 public:
  template <class Acceleration>
  void do_step(Acceleration&& acceleration, Half& q, Half& v, const Scalar&, const Scalar& h) {
    drift(q, v, h / 2);
    acceleration(q, a_);
    drift(v, a_, h);
    drift(q, v, h / 2);
  }

 private:
  static void drift(Half& x, const Half& rate, const Scalar& h) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * rate[i];
  }

  Half a_{};
};

/// Order 2, one acceleration in a step, symmetric: the cheapest that keeps the energy bounded (Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1.4).
template <class Model>
using Verlet = NystromStepper<Model, PositionVerlet<typename HalfArrays<Model>::Array, typename Model::Scalar>>;

/// Order 4, five accelerations in a step, symmetric; R. I. McLachlan, On the numerical integration of ordinary differential equations by
/// symmetric composition methods, SIAM Journal on Scientific Computing 16 (1995) 151-168.
template <class Model>
using McLachlan4 =
    NystromStepper<Model,
                   boost::numeric::odeint::symplectic_rkn_sb3a_m4_mclachlan<
                       typename HalfArrays<Model>::Array, typename HalfArrays<Model>::Array, typename Model::Scalar>>;

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_NYSTROM_STEPPER_HPP
