#pragma once
// Extrapolation of the midpoint rule by Odeint, of an order that it chooses (Bulirsch and Stoer 1966; Hairer, Nørsett, Wanner I, II.9).
//
// Odeint's error checker is part of the stepper: |error| / (eps_abs + eps_rel |x|), one pair of tolerances for all components. So the stepper sees each component divided by
// what an error of it may be, which makes eps_abs = 1 and eps_rel = 0 the measure of gauss::simulate::StepControl.

#include <algorithm>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <functional>
#include <limits>

#include "gauss/integrate/projection_near.hpp"
#include "gauss/simulate/rounding.hpp"
#include "gauss/simulate/step_control.hpp"
#include "sim/drive/integrator.hpp"
#include "sim/drive/odeint_numbers.hpp"
#include "sim/drive/project_start.hpp"

namespace gausssim {

template <class S>
class BulirschStoer final : public Integrator<S> {
 public:
  using Array = Numbers<S>;
  using Model = MotionModel<S>;

  BulirschStoer(const Model& model, const Array& start, const S& t, const gauss::simulate::Settings<S>& settings)
      : model_(model), settings_(settings), t_(t), x_(start), rates_(start), unit_(start) {
    if (!settings_.are_usable()) progress_.outcome = Outcome::bad_settings;
    if (settings_.project) {
      typename Model::State state{x_};
      project_start(model_, t_, state, progress_);
      x_ = state.values;
    }
    control_.grow(x_);
  }
  BulirschStoer(const BulirschStoer&) = delete;
  BulirschStoer& operator=(const BulirschStoer&) = delete;

  bool advance_to(const S& end) override {
    while (t_ < end && is_running()) step_once(end);
    return is_running() && t_ == end;
  }
  S time() const override { return t_; }
  const Array& state() const override { return x_; }
  Progress<S> progress() const override {
    Progress<S> progress = progress_;
    progress.calls = system_.calls();
    return progress;
  }

 private:
  using Outcome = gauss::simulate::Outcome;
  using Stepper = boost::numeric::odeint::bulirsch_stoer<Array, S, Array, S>;

  bool is_running() const { return progress_.outcome == Outcome::running; }

  void step_once(const S& end) {
    progress_.outcome = settings_.before_step(progress_.steps);
    if (!is_running()) return;
    system_.forget();
    system_(x_, rates_, t_);
    if (!gauss::integrate::is_motion_known(system_.trouble())) return stop(Outcome::model_failed);
    // An order in the middle of those that there are.
    constexpr int k_usual_order = 8;
    if (!(step_ > S(0))) step_ = gauss::Math<S>::pow(settings_.tolerance, S(1) / k_usual_order) * (end - t_);
    if (!(first_ > S(0))) first_ = std::min(step_, end - t_);
    bool is_taken = false, was_refused = false;
    while (!is_taken && is_running()) {
      const S wanted = settings_.longest_step > S(0) ? std::min(step_, settings_.longest_step) : step_;
      if (shortest_in_a_row_ > k_most_shortest || shortest_ > k_most_edges) return stop(Outcome::step_too_small);
      const bool arrives = gauss::simulate::arrives(t_, wanted, end, was_refused);
      is_taken = attempt(arrives ? end - t_ : wanted, arrives ? end : t_ + wanted);
      was_refused = !is_taken;
      // What comes after a step that was cut off to arrive is not known better than before it.
      if (is_taken && arrives) step_ = std::max(step_, wanted);
    }
  }

  /// One trial from t_; sets step_ to what comes next.
  bool attempt(const S& dt, const S& next) {
    const S rounding = std::numeric_limits<S>::epsilon() * std::max(first_, gauss::integrate::magnitude(t_));
    const bool is_shortest = !(dt > 4 * rounding);
    shortest_in_a_row_ = is_shortest ? shortest_in_a_row_ + 1 : 0;
    if (is_shortest) ++shortest_;
    Array x = x_, rates = rates_, result = x_;
    unit_ = control_.allowed(settings_.tolerance, dt);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] /= unit_[i];
      rates[i] /= unit_[i];
    }
    S t = t_, tried = dt;
    const auto outcome = stepper_.try_step(std::ref(scaled_), x, rates, t, result, tried);
    step_ = tried;
    for (std::size_t i = 0; i < x.size(); ++i) result[i] *= unit_[i];
    const bool is_accurate = (outcome == boost::numeric::odeint::success || is_shortest) && is_finite(result);
    if (gauss::integrate::is_motion_known(system_.trouble()) && is_accurate && arrives_at(next, result)) return true;
    ++progress_.rejected;
    if (!(step_ < dt)) step_ = dt / 4;
    if (!gauss::integrate::is_motion_known(system_.trouble())) {
      progress_.status = system_.trouble();
      system_.forget();
    }
    return false;
  }

  /// False where projection moves the state by more than errors of steps explain: a shorter step may stay on this side of the trouble.
  bool arrives_at(const S& next, const Array& result) {
    typename Model::State state{result};
    if (settings_.project) {
      const auto is_near = [&] {
        for (std::size_t i = 0; i < result.size(); ++i)
          if (!(gauss::integrate::magnitude(state.values[i] - result[i]) <= settings_.most_projected * unit_[i]))
            return false;
        return true;
      };
      const gauss::Status status =
          gauss::integrate::projection_near(model_, next, typename Model::State{result}, state, is_near);
      if (!gauss::integrate::is_motion_known(status)) return progress_.status = status, false;
      if (!is_near()) return false;
    }
    t_ = next;
    x_ = state.values;
    control_.grow(x_);
    ++progress_.steps;
    if (system_.trouble() != gauss::Status::ok) ++progress_.with_fewer_constraints;
    return true;
  }

  static bool is_finite(const Array& x) {
    return std::all_of(x.begin(), x.end(), [](const S& value) { return value - value == S(0); });
  }

  void stop(Outcome outcome) {
    progress_.outcome = outcome;
    if (system_.trouble() != gauss::Status::ok) progress_.status = system_.trouble();
  }

  /// Rates of the components divided by their units.
  struct Scaled {
    BulirschStoer& of;
    void operator()(const Array& x, Array& dxdt, const S& t) {
      Array real = x;
      for (std::size_t i = 0; i < x.size(); ++i) real[i] *= of.unit_[i];
      of.system_(real, dxdt, t);
      for (std::size_t i = 0; i < x.size(); ++i) dxdt[i] /= of.unit_[i];
    }
  };

  Model model_;
  gauss::simulate::Settings<S> settings_;
  /// What rests is off by all that a force does to it which begins to act within a step, be it as short as rounding of time: then that is what time tells of the edge. One or
  /// two of these lead over it; more of them are no edge.
  static constexpr int k_most_shortest = 8;
  static constexpr int k_most_edges = 100;  ///< in all: what sticks where a force jumps would cross one for ever

  S t_, step_ = 0, first_ = 0;
  int shortest_in_a_row_ = 0, shortest_ = 0;
  Array x_, rates_, unit_;
  gauss::simulate::NotingSystem<Model> system_{model_};
  gauss::simulate::StepControl<Model> control_{model_, settings_.tolerance, system_};
  Scaled scaled_{*this};
  Stepper stepper_{S(1), S(0), S(1), S(0)};
  Progress<S> progress_;
};

}  // namespace gausssim
