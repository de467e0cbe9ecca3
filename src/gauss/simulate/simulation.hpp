// Integration in time with projection: every accepted state satisfies the constraints.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_SIMULATION_HPP
#define GAUSS_SIMULATE_SIMULATION_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>

#include "gauss/integrate/model_decorator.hpp"
#include "gauss/integrate/odeint.hpp"
#include "gauss/integrate/projection_near.hpp"
#include "gauss/simulate/report.hpp"
#include "gauss/simulate/rounding.hpp"
#include "gauss/simulate/step_control.hpp"

namespace gauss::simulate {

/// Time is the start plus the steps taken, and each requested time is set exactly when it is reached, so that rounding does
/// not add up over the samples.
///
/// `Method` is a stepper of Odeint with an estimate of its error, for std::array<Scalar, Model::size>.
template <class Model, class Method = integrate::PrinceDormand87<integrate::StateArray<Model>, typename Model::Scalar>>
class Simulation {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  using Status = typename Model::Status;

  Simulation(const Model& model, const State& start, const Scalar& start_time = 0,
             const Settings<Scalar>& settings = {})
      : model_(model),
        settings_(settings),
        system_(model_),
        t_(start_time),
        step_(settings.first_step),
        x_(Arrays::array_of(start)) {
    if (!settings_.are_usable() || !(start_time - start_time == Scalar(0))) {
      report_.outcome = Outcome::bad_settings;
      return;
    }
    if (settings_.project) project_start();
    for (std::size_t i = 0; i < x_.size(); ++i)
      control_.set_smallest(i, i < Arrays::n_q(model_) ? settings_.smallest_scale : settings_.least_speed());
    control_.grow(x_);
    system_.set_allowed([this](const Scalar& dt) -> const Array& { return control_.allowed(settings_.tolerance, dt); });
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
      report_.outcome = settings_.before_step(report_.steps);
      if (report_.outcome == Outcome::running) step_towards(end, on_step);
    }
    report_.calls = system_.calls();
    report_.jacobians = system_.jacobians();
    return report_.outcome == Outcome::running && t_ == end;
  }

  /// One accepted step, not beyond `end`. False as above, but for the time that it gets to.
  bool step_towards(const Scalar& end) {
    if (!(t_ < end)) return t_ == end && report_.outcome == Outcome::running;
    const long before = report_.steps;
    while (report_.steps == before && report_.outcome == Outcome::running) {
      report_.outcome = settings_.before_step(report_.steps);
      if (report_.outcome == Outcome::running) step_towards(end, [](const Scalar&, const State&, const State&) {});
    }
    report_.calls = system_.calls();
    report_.jacobians = system_.jacobians();
    return report_.outcome == Outcome::running;
  }

  /// How large components have been in the same motion, before this part of it: scales of errors are no less.
  void know_sizes(const integrate::StateArray<Model>& sizes) { control_.grow(sizes); }

  /// What rounding makes of rates, at least, as of forces that cancel each other where contacts hold a body.
  void know_rounding(const integrate::StateArray<Model>& of_rates) { control_.set_least_rounding(of_rates); }

  const Scalar& time() const { return t_; }
  State state() const { return Arrays::state_of(x_); }
  /// As it is in force: of one that writes its state in other coordinates from time to time.
  const Model& model() const { return model_; }
  const Report<Status, Scalar>& report() const { return report_; }

 private:
  using System = NotingSystem<Model>;
  using Control = StepControl<Model>;
  using Array = typename Control::Array;
  using Arrays = integrate::StateArrays<Model>;

  /// The last stage of some methods is the first one of the next step, where nothing has moved the state since.
  Array rates_here() {
    system_.forget();
    if (are_rates_known_) return last_rates_;
    Array rates = integrate::zeros_like(x_);
    system_(x_, rates, t_);
    return rates;
  }

  /// One step knows nothing of those before it.
  void rewrite() {
    if constexpr (integrate::Rewrites<Model>::value) {
      State state = Arrays::state_of(x_);
      if (!model_.rewrite(state)) return;
      are_rates_known_ = false;
      x_ = Arrays::array_of(state);
      control_.grow(x_);
    }
  }

  /// What a start misses the constraints by is no error of a step. Where it cannot be mended, the first step will tell.
  void project_start() {
    const State given = Arrays::state_of(x_);
    State start = given;
    if (!integrate::is_motion_known(model_.projection(t_, start))) return;
    report_.compare_start(given, start, x_.size());
    x_ = Arrays::array_of(start);
  }

  template <class OnStep>
  void step_towards(const Scalar& end, OnStep&& on_step) {
    rewrite();
    const Array rates = rates_here();
    if (!integrate::is_motion_known(system_.trouble())) {
      report_.outcome = Outcome::model_failed;
      report_.status = system_.trouble();
      return;
    }
    // What starts at 0 has no size yet that rates could be compared with: the error is, of a guess that is too long for most.
    using std::pow;
    // As a number: Odeint defines no object that number types of libraries could refer to.
    constexpr int order = Method::order_value;
    if (step_ <= Scalar(0)) step_ = pow(settings_.tolerance, Scalar(1) / order) * (end - t_);
    if (first_ <= Scalar(0)) control_.set_reach(first_ = std::min(step_, end - t_));
    int refused = 0;
    const bool approaches = is_held_ && settings_.crosses_lost_digits;
    system_.close(approaches && approach_.loses_digits());
    if (system_.is_closed() && crosses(rates, end, on_step)) return;
    // Steps as short as these resolve what rounding makes of the place, which leads to any of its branches.
    if (approaches && approach_.has_lost_digits() && approach_.dt < k_brief * control_.reach())
      report_.outcome = Outcome::constraints_lost;
    while (report_.outcome == Outcome::running) {
      // The controller's step is kept for afterwards when this one is cut off to arrive at `end`.
      if (settings_.longest_step > Scalar(0)) step_ = std::min(step_, settings_.longest_step);
      const Scalar wanted = step_;
      const bool arrives = simulate::arrives(t_, wanted, end, refused > 0);
      const Scalar dt = arrives ? end - t_ : wanted;
      State before = state(), after = before;
      if (!attempt(rates, dt, before, after)) {
        find_sizes_by_constraints(t_ + dt, before);
        if (++refused == 1) approach_.note_refused(dt, find_rounding(rates));
        reject(dt);
        continue;
      }
      approach_.note_taken(dt, refused);
      if (arrives) step_ = std::max(step_, wanted);
      step_ = std::max(step_, control_.take_step_before_edge());
      take(arrives ? end : t_ + dt, before, after, on_step);
      return;
    }
  }

  template <class OnStep>
  void take(const Scalar& t, const State& before, const State& after, OnStep&& on_step) {
    t_ = t;
    are_rates_known_ = k_keeps_last_stage && Arrays::array_of(before) == Arrays::array_of(after);
    x_ = Arrays::array_of(after);
    control_.grow(x_);
    ++report_.steps;
    if (system_.trouble() != Status{}) ++report_.with_fewer_constraints;
    on_step(t_, before, after);
  }

  /// Over the place that steps become shorter and shorter towards: of some longer steps, the one with the smallest error. False where that
  /// has less than half of the digits that are asked for.
  template <class OnStep>
  bool crosses(const Array& rates, const Scalar& end, OnStep&& on_step) {
    using std::sqrt;
    const Scalar most = 1 / sqrt(settings_.tolerance), step = step_;
    Scalar best = most, best_dt = 0;
    State before = state(), after = before;
    const Scalar longest = settings_.longest_step > Scalar(0) ? settings_.longest_step : end - t_;
    for (const Scalar& wanted : approach_.longer_steps()) {
      const Scalar dt = std::min({wanted, longest, end - t_});
      attempt(rates, dt, before, after, most);
      const bool is_whole = integrate::is_motion_known(system_.trouble()) && !jumped_;
      if (is_whole && control_.last_error() < best) {
        best = control_.last_error();
        best_dt = dt;
      }
      system_.forget();
    }
    approach_ = {};
    step_ = step;
    if (best_dt <= Scalar(0)) return false;
    attempt(rates, best_dt, before, after, most);
    step_ = std::max(step, best_dt);
    ++report_.crossings;
    take(best_dt == end - t_ ? end : t_ + best_dt, before, after, on_step);
    return true;
  }

  /// One trial step and its projection, also of one with an error up to `most`; sets step_ to what comes next.
  bool attempt(const Array& rates, const Scalar& dt, State& before, State& after, const Scalar& most = 1) {
    Array trial = x_;
    Scalar time = t_;
    step_ = dt;
    const bool is_accurate = try_step(rates, time, trial) == boost::numeric::odeint::success;
    before = Arrays::state_of(trial);
    after = before;
    Status status = system_.trouble();
    const bool is_candidate = is_accurate || control_.last_error() < most;
    const auto is_near_enough = [&] {
      return is_near(dt, before, after, std::max(most * settings_.tolerance, settings_.tolerance));
    };
    if (is_candidate && integrate::is_motion_known(status) && settings_.project)
      status = integrate::projection_near(model_, t_ + dt, before, after, is_near_enough);
    const bool is_known = integrate::is_motion_known(status);
    const bool has_moved = Arrays::array_of(before) != Arrays::array_of(after);
    if (is_known && has_moved) is_held_ = true;
    jumped_ = is_known && is_candidate && has_moved && !is_near_enough();
    if (is_known && !jumped_) return is_accurate;
    // A shorter step may stay on this side of the trouble.
    report_.status = status;
    step_ = std::min(step_, dt / 5);
    return false;
  }

  auto try_step(const Array& rates, Scalar& time, Array& trial) {
    if constexpr (k_keeps_last_stage) {
      return stepper_.try_step(std::ref(system_), x_, rates, time, trial, last_rates_, step_);
    } else {
      return stepper_.try_step(std::ref(system_), x_, rates, time, trial, step_);
    }
  }

  /// Where constraints lose their rank, projection may take any part of the motion away.
  bool is_near(const Scalar& dt, const State& before, const State& after, const Scalar& tolerance) const {
    const Array& allowed = control_.allowed(std::max(tolerance, std::numeric_limits<Scalar>::epsilon()), dt);
    for (std::size_t i = 0; i < x_.size(); ++i)
      if (!(integrate::magnitude(after.values[i] - before.values[i]) <= settings_.most_projected * allowed[i]))
        return false;
    return true;
  }

  /// Returns what part of rates it is.
  Scalar find_rounding(const Array& rates) {
    Array changes = integrate::zeros_like(x_);
    const auto derivative = [&](const Array& x, Array& result) {
      system_.forget();
      system_(x, result, t_);
      return integrate::is_motion_known(system_.trouble());
    };
    if (!changes_by_rounding(x_, rates, derivative, changes)) changes = integrate::zeros_like(x_);
    control_.set_rounding(changes);
    Scalar lost = 0, all = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (!(control_.usual_size(i) > Scalar(0))) continue;
      lost = std::max(lost, changes[i] / control_.usual_size(i));
      all = std::max(all, integrate::magnitude(rates[i]) / control_.usual_size(i));
    }
    return all > Scalar(0) ? lost / all : Scalar(0);
  }

  /// At a state at which a step has arrived.
  void find_sizes_by_constraints(const Scalar& t, const State& state) {
    if (!settings_.project) return;
    const Array x = Arrays::array_of(state);
    control_.find_by_constraints(x, [&](const Array& near, Array& result) {
      State moved = Arrays::state_of(near);
      if (!integrate::is_motion_known(model_.projection(t, moved))) return false;
      result = Arrays::array_of(moved);
      return true;
    });
  }

  // Times may be of any unit: near 0, rounding is that of the first step.
  void reject(const Scalar& dt) {
    ++report_.rejected;
    system_.forget();
    const Scalar rounding = std::numeric_limits<Scalar>::epsilon() * std::max(first_, integrate::magnitude(t_));
    if (dt > 4 * rounding && step_ > 0) return;
    report_.outcome = jumped_ ? Outcome::constraints_lost : Outcome::step_too_small;
  }

  // Where constraints nearly lose their rank, as at the change point of a linkage, rates have the fewer digits the nearer a state is. A step over that place
  // is refused, however short, while one that ends before it is taken: steps would shrink to nothing there, or end on another
  // branch. (Towards an edge of a force, steps shrink likewise, but rates keep their digits.)
  struct Approach {
    static constexpr int k_steps = 2;
    static constexpr double k_lost = 1e-6;  ///< of rates

    int steps = 0;  ///< that were refused at first, since one that was as long as the first of them
    Scalar first_dt = 0, first_rounding = 0, dt = 0, refused_dt = 0, rounding = 0;

    void note_refused(const Scalar& of_dt, const Scalar& of_rounding) {
      refused_dt = of_dt;
      rounding = of_rounding;
    }
    void note_taken(const Scalar& of_dt, int times_refused) {
      if (steps > 0 && !(of_dt < first_dt)) steps = 0;
      dt = of_dt;
      if (times_refused == 0) return;
      if (++steps > 1) return;
      first_dt = of_dt;
      first_rounding = rounding;
    }
    /// A step of the length that was refused reaches the place; others look at it from elsewhere.
    std::array<Scalar, 6> longer_steps() const {
      const Scalar longest = std::max(refused_dt, dt);
      return {longest, longest * Scalar(1.5), longest * Scalar(2.2), longest * Scalar(3.3), 5 * longest, 8 * longest};
    }
    bool loses_digits() const { return steps > k_steps && rounding > 4 * first_rounding; }
    bool has_lost_digits() const { return steps > k_steps && rounding > k_lost; }
  };
  static constexpr double k_brief = 1e-4;  ///< of the longest step
  static constexpr bool k_keeps_last_stage =
      std::is_same_v<typename Method::stepper_category, boost::numeric::odeint::explicit_error_stepper_fsal_tag>;

  Model model_;
  Settings<Scalar> settings_;
  System system_;
  Scalar t_;
  Scalar step_;
  Scalar first_ = 0;      ///< the first step, tried or given
  bool is_held_ = false;  ///< by constraints: projection has moved a state
  Approach approach_;
  bool jumped_ = false;  ///< the last trial, by its projection
  Array x_;
  Array last_rates_ = x_;
  bool are_rates_known_ = false;
  Control control_{model_, settings_.tolerance, system_};
  integrate::Stepper<Method, Control> stepper_ = integrate::make_stepper<Method>(control_);
  Report<Status, Scalar> report_;
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_SIMULATION_HPP
