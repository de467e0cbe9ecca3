// Integration in time with projection: every accepted state satisfies the constraints.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_SIMULATION_HPP
#define GAUSS_SIMULATE_SIMULATION_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "gauss/integrate/model_decorator.hpp"
#include "gauss/integrate/odeint.hpp"
#include "gauss/simulate/report.hpp"

namespace gauss::simulate {

/// Time is the start plus the steps taken, and each requested time is set exactly when it is reached, so that rounding does
/// not add up over the samples.
template <class Model>
class Simulation {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  using Status = typename Model::Status;

  Simulation(const Model& model, const State& start, const Scalar& start_time = 0,
             const Settings<Scalar>& settings = {})
      : model_(model), settings_(settings), system_(model_), t_(start_time), step_(settings.first_step) {
    std::copy_n(start.values, Model::size, x_.begin());
    if (!settings_.are_usable() || !(start_time - start_time == Scalar(0))) {
      report_.outcome = Outcome::bad_settings;
      return;
    }
    if (settings_.project) project_start();
    scale_.fill(settings_.smallest_scale);
    for (std::size_t i = Model::n_q; i < Model::size; ++i) scale_[i] = settings_.least_speed();
    grow_scale();
  }

  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Integrates to `end`, where the last step is shortened to arrive. False: it did not get there, see report(); or `end` is no time from
  /// here on.
  bool advance_to(const Scalar& end) {
    return advance_to(end, [](const Scalar&, const State&, const State&) {});
  }

  /// After each accepted step `on_step(t, before, after)` sees the state before and after projection.
  template <class OnStep>
  bool advance_to(const Scalar& end, OnStep&& on_step) {
    while (t_ < end && report_.outcome == Outcome::running) {
      if (report_.steps >= settings_.most_steps) {
        report_.outcome = Outcome::too_many_steps;
      } else {
        step_towards(end, on_step);
      }
    }
    report_.calls = system_.calls();
    return report_.outcome == Outcome::running && t_ == end;
  }

  const Scalar& time() const { return t_; }
  State state() const { return as_state(x_); }
  /// As it is in force: of one that writes its state in other coordinates from time to time.
  const Model& model() const { return model_; }
  const Report<Status, Scalar>& report() const { return report_; }

 private:
  using System = integrate::OdeintSystem<Model>;
  using Array = typename System::Array;

  static State as_state(const Array& x) {
    State state;
    std::copy(x.begin(), x.end(), state.values);
    return state;
  }

  /// One step knows nothing of those before it.
  void rewrite() {
    if constexpr (integrate::Rewrites<Model>::value) {
      State state = as_state(x_);
      if (!model_.rewrite(state)) return;
      std::copy_n(state.values, Model::size, x_.begin());
      grow_scale();
    }
  }

  /// What a start misses the constraints by is no error of a step. Where it cannot be mended, the first step will tell.
  void project_start() {
    const State given = as_state(x_);
    State start = given;
    if (!integrate::is_motion_known(model_.projection(t_, start))) return;
    report_.compare_start(given, start, Model::size);
    std::copy_n(start.values, Model::size, x_.begin());
  }

  template <class OnStep>
  void step_towards(const Scalar& end, OnStep&& on_step) {
    rewrite();
    Array rates{};
    system_.forget_trouble();
    system_(x_, rates, t_);
    if (!integrate::is_motion_known(system_.trouble())) {
      report_.outcome = Outcome::model_failed;
      report_.status = system_.trouble();
      return;
    }
    if (step_ <= Scalar(0)) step_ = first_step(rates);
    if (first_ <= Scalar(0)) first_ = step_;
    while (report_.outcome == Outcome::running) {
      // The controller's step is kept for afterwards when this one is cut off to arrive at `end`.
      if (settings_.longest_step > Scalar(0)) step_ = std::min(step_, settings_.longest_step);
      const Scalar wanted = step_;
      const bool arrives = t_ + wanted >= end;
      const Scalar dt = arrives ? end - t_ : wanted;
      State before{}, after{};
      if (!attempt(rates, dt, before, after)) {
        reject(dt);
        continue;
      }
      if (arrives) step_ = std::max(step_, wanted);
      t_ = arrives ? end : t_ + dt;
      std::copy_n(after.values, Model::size, x_.begin());
      grow_scale();
      ++report_.steps;
      if (system_.trouble() != Status{}) ++report_.with_fewer_constraints;
      on_step(t_, before, after);
      return;
    }
  }

  /// One trial step and its projection; sets step_ to what comes next.
  bool attempt(const Array& rates, const Scalar& dt, State& before, State& after) {
    Array trial{};
    Scalar time = t_;
    step_ = dt;
    const bool is_accurate =
        stepper_.try_step(std::ref(system_), x_, rates, time, trial, step_) == boost::numeric::odeint::success;
    before = as_state(trial);
    after = before;
    Status status = system_.trouble();
    if (is_accurate && integrate::is_motion_known(status) && settings_.project) status = model_.projection(time, after);
    const bool is_known = integrate::is_motion_known(status);
    jumped_ = is_known && is_accurate && !is_near(before, after);
    if (is_known && !jumped_) return is_accurate;
    // A shorter step may stay on this side of the trouble.
    report_.status = status;
    step_ = std::min(step_, dt / 5);
    return false;
  }

  /// Where constraints lose their rank, projection may take any part of the motion away.
  bool is_near(const State& before, const State& after) const {
    const Scalar unit =
        settings_.most_projected * std::max(settings_.tolerance, std::numeric_limits<Scalar>::epsilon());
    for (std::size_t i = 0; i < Model::size; ++i) {
      if (!(std::abs(after.values[i] - before.values[i]) <= unit * scale_[i])) return false;
    }
    return true;
  }

  // Times may be of any unit: near 0, rounding is that of the first step.
  void reject(const Scalar& dt) {
    ++report_.rejected;
    system_.forget_trouble();
    const Scalar rounding = std::numeric_limits<Scalar>::epsilon() * std::max(first_, std::abs(t_));
    if (dt > 4 * rounding && step_ > 0) return;
    report_.outcome = jumped_ ? Outcome::constraints_lost : Outcome::step_too_small;
  }

  void grow_scale() {
    for (std::size_t i = 0; i < Model::size; ++i) scale_[i] = std::max(scale_[i], std::abs(x_[i]));
  }

  // The time in which the fastest component changes by a part of its scale that an error of order 8 resolves.
  Scalar first_step(const Array& rates) const {
    Scalar fastest = 0;
    for (std::size_t i = 0; i < Model::size; ++i) fastest = std::max(fastest, std::abs(rates[i]) / scale_[i]);
    const Scalar part = std::pow(settings_.tolerance, Scalar(1) / 8);
    return fastest > 0 ? part / fastest : part;
  }

  Model model_;
  Settings<Scalar> settings_;
  System system_;
  Scalar t_;
  Scalar step_;
  Scalar first_ = 0;     ///< the first step, tried or given
  bool jumped_ = false;  ///< the last trial, by its projection
  Array x_{};
  Array scale_{};
  integrate::Stepper<Scalar, Model::size> stepper_ =
      integrate::make_stepper(integrate::ScaledError<Scalar, Model::size>(settings_.tolerance, scale_));
  Report<Status, Scalar> report_;
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_SIMULATION_HPP
