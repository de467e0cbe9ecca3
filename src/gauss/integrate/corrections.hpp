// Steppers that correct the states of another stepper: constraints, energy.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_CORRECTIONS_HPP
#define GAUSS_INTEGRATE_CORRECTIONS_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/state_arrays.hpp"
#include "gauss/integrate/step_result.hpp"
#include "gauss/math.hpp"

namespace gauss::integrate {

/// What corrections did since the beginning of a run.
template <class Scalar>
struct Correction {
  Scalar largest = 0;   ///< of one component in one step: of its own unit for projection, a fraction for energy
  long applied = 0;     ///< steps that were corrected
  long left_alone = 0;  ///< steps for which no correction would have been an improvement
};

/// Levels of projection. A level that the model was not generated with does not compile.
struct ToConstraints {
  template <class Model>
  static Status apply(const Model& model, const typename Model::Scalar& t, typename Model::State& state) {
    return model.projection(t, state);
  }
};

namespace detail {

/// Some component has moved by more than rounding and what Newton's next step would move. A crude measure: it only says where to look again.
template <class State>
bool still_moves(const State& before, const State& after) {
  for (std::size_t i = 0; i < std::size(after.values); ++i) {
    if (!(magnitude(after.values[i] - before.values[i]) <= 1e-8 * magnitude(after.values[i]))) return true;
  }
  return false;
}

/// As many steps of Newton's method as `project` takes, on one level. The status is the one that stops a motion, or else whether one of them found rows dependent.
/// Positions that are off are the rule for speeds alone, and a step of positions does not say that it was not the last: what `project` says at
/// the nearest state decides where the steps leave a doubt.
template <class Model, class Step>
Status repeated(const Model& model, const typename Model::Scalar& t, typename Model::State& state, const Step& step) {
  const auto may_go_on = [](Status status) {
    return is_motion_known(status) || status == Status::violated_constraints;
  };
  Status status = Status::ok;
  auto before = state;
  for (int i = 0; i < 6 && may_go_on(status); ++i) {
    before = state;
    const Status now = step();
    if (now != Status::ok || status != Status::dependent_constraints) status = now;
  }
  const bool is_settled = is_motion_known(status) && !still_moves(before, state);
  if (is_settled || !may_go_on(status)) return status;
  auto nearest = state;
  const Status there = model.projection(t, nearest);
  return is_motion_known(status) && is_motion_known(there) ? status : there;
}

}  // namespace detail

/// Equations of positions alone: loops stay closed, while speeds drift off their constraints.
struct ToPositions {
  template <class Model>
  static Status apply(const Model& model, const typename Model::Scalar& t, typename Model::State& state) {
    return detail::repeated(model, t, state, [&] { return model.position_step(t, state); });
  }
};

/// Constraints of velocities alone.
struct ToSpeeds {
  template <class Model>
  static Status apply(const Model& model, const typename Model::Scalar& t, typename Model::State& state) {
    return detail::repeated(model, t, state, [&] { return model.speed_step(t, state); });
  }
};

/// Back onto the constraints after each step.
template <class Inner, class Level = ToConstraints>
class Projected {
 public:
  using Scalar = typename Inner::Scalar;
  using State = typename Inner::State;

  Projected() = default;
  explicit Projected(Inner inner) : inner_(std::move(inner)) {}

  template <class Model>
  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    State trial = state;
    const StepResult result = inner_.step(model, t, h, trial);
    if (!result.is_taken()) return result;
    const State before = trial;
    const StepResult projected = result_of(Level::apply(model, t + h, trial));
    if (!projected.is_taken()) return projected;
    for (std::size_t i = 0; i < Model::size; ++i)
      correction_.largest = std::max(correction_.largest, magnitude(trial.values[i] - before.values[i]));
    ++correction_.applied;
    state = trial;
    return result;
  }

  const Correction<Scalar>& correction() const { return correction_; }
  const Inner& inner() const { return inner_; }

 private:
  Inner inner_;
  Correction<Scalar> correction_;
};

namespace detail {

/// Scales the speeds so that the energy is `level`. Returns the part of them that is added, or -1 where no factor is an improvement.
template <class Energy, class Model>
typename Model::Scalar to_energy(const Model& model, const typename Model::Scalar& t,
                                 const typename Model::Scalar& level, typename Model::State& state) {
  using Scalar = typename Model::Scalar;
  Energy energy;
  if (!is_motion_known(model.energy(t, state, energy))) return -1;
  const Scalar miss = level - energy.total;
  // Near rest no factor helps: the energy is missed by the positions, and speeds would have to make up for it.
  if (!(magnitude(miss) <= energy.kinetic / 4)) return -1;
  typename Model::State scaled = state;
  const Scalar factor = Math<Scalar>::sqrt(1 + miss / energy.kinetic);
  using Arrays = StateArrays<Model>;
  for (std::size_t i = Arrays::n_q(model); i < Arrays::size(model); ++i) scaled.values[i] *= factor;
  Energy after;
  if (!is_motion_known(model.energy(t, scaled, after)) || !(magnitude(level - after.total) < magnitude(miss)))
    return -1;
  state = scaled;
  return magnitude(factor - 1);
}

}  // namespace detail

/// Keeps the energy of a scleronomic, conservative model at its value before the first step, by a factor on all speeds,
/// sqrt((E0 - V)/T): of all changes of speeds that give this energy, the least in the metric of the masses, and one that keeps
/// homogeneous constraints of speeds. `Energy` is the emitted struct, such as gauss::pendulum::Energy<double>. Where the generator does not know that
/// it is conserved, as with a generalized force that has a potential, `is_conserved` says so.
template <class Inner, class Energy, bool is_conserved = Energy::is_conserved>
class EnergyKept {
  static_assert(is_conserved,
                "the energy of this model may change: laws in time, dampers, inputs or forces without a potential");

 public:
  using Scalar = typename Inner::Scalar;
  using State = typename Inner::State;

  EnergyKept() = default;
  explicit EnergyKept(Inner inner) : inner_(std::move(inner)) {}

  template <class Model>
  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    Energy energy;
    if (!has_level_) {
      const StepResult start = result_of(model.energy(t, state, energy));
      if (!start.is_taken()) return start;
      level_ = energy.total;
      has_level_ = true;
    }
    const StepResult result = inner_.step(model, t, h, state);
    if (result.is_taken()) correct(model, t + h, state);
    return result;
  }

  const Correction<Scalar>& correction() const { return correction_; }
  const Scalar& level() const { return level_; }
  const Inner& inner() const { return inner_; }

 private:
  template <class Model>
  void correct(const Model& model, const Scalar& t, State& state) {
    const Scalar change = detail::to_energy<Energy>(model, t, level_, state);
    if (!(change >= 0)) {
      ++correction_.left_alone;
      return;
    }
    correction_.largest = std::max(correction_.largest, change);
    ++correction_.applied;
  }

  Inner inner_;
  Correction<Scalar> correction_;
  Scalar level_ = 0;
  bool has_level_ = false;
};

/// The same for simulations with an estimate of their error, which take no steppers but project by themselves: the model `Base`, a BoundModel, whose projection
/// also brings the energy back to that of the start.
template <class Base, class Energy, bool is_conserved = Energy::is_conserved>
class WithEnergyKept : public Base {
  static_assert(is_conserved,
                "the energy of this model may change: laws in time, dampers, inputs or forces without a potential");

 public:
  using Scalar = typename Base::Scalar;
  using State = typename Base::State;

  /// Where the model does not know the energy of the start, nothing is corrected, and the first step says why.
  WithEnergyKept(const Base& base, const Scalar& t, const State& start)
      : Base(base), level_(std::numeric_limits<Scalar>::quiet_NaN()) {
    Energy energy;
    if (is_motion_known(Base::energy(t, start, energy))) level_ = energy.total;
  }

  /// Simulations leave the energy alone where that is what keeps a state near, see projection_near().
  static constexpr bool keeps_energy() { return true; }
  Status constraint_projection(const Scalar& t, State& state) const { return Base::projection(t, state); }
  Status projection(const Scalar& t, State& state) const {
    const Status status = constraint_projection(t, state);
    if (is_motion_known(status)) detail::to_energy<Energy>(static_cast<const Base&>(*this), t, level_, state);
    return status;
  }

 private:
  Scalar level_;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_CORRECTIONS_HPP
