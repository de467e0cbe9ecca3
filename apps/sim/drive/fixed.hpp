#pragma once
// Steps of one length, by a stepper in the sense of gauss/integrate/explicit_stepper.hpp.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "gauss/integrate/step_result.hpp"
#include "gauss/integrate/time_grid.hpp"
#include "sim/drive/integrator.hpp"
#include "sim/drive/project_start.hpp"

namespace gausssim {

/// Each way to `advance_to` is divided into equal steps, none longer than `step`, up to rounding.
template <class S, class Stepper>
class Fixed final : public Integrator<S> {
 public:
  using Array = Numbers<S>;
  using Model = MotionModel<S>;

  /// `calls_in_a_step` 0: the stepper knows.
  Fixed(const Model& model, const Array& start, const S& t, const S& step, const gauss::simulate::Settings<S>& settings,
        long calls_in_a_step)
      : model_(model),
        state_{start},
        t_(t),
        step_(step),
        settings_(settings),
        projects_(model.projects()),
        calls_in_a_step_(calls_in_a_step) {
    if (projects_) project_start(model_, t_, state_, progress_);
  }

  bool advance_to(const S& end) override {
    using std::ceil;
    const S way = end - t_;
    if (!(way > S(0)) || !is_running()) return is_running() && way == S(0);
    const S wanted = ceil((way - std::min(rounding_of(end), S(step_ / 8))) / step_ * S(1 - k_rounding));
    // No run takes so many, and no integer counts them all.
    if (!(wanted < S(k_most_steps))) return progress_.outcome = Outcome::too_many_steps, false;
    const auto count = static_cast<long>(std::max(wanted, S(1)));
    const gauss::integrate::TimeGrid<S> grid(t_, way / S(count));
    for (long k = 0; k < count && is_running(); ++k)
      step(grid.at(k), grid.step(), k + 1 == count ? end : grid.at(k + 1));
    return is_running();
  }

  S time() const override { return t_; }
  const Array& state() const override { return state_.values; }
  Progress<S> progress() const override { return progress_; }

 private:
  using Outcome = gauss::simulate::Outcome;
  using StepOutcome = gauss::integrate::StepOutcome;

  static constexpr double k_most_steps = 1e15;
  static constexpr double k_rounding = 1e-12;  ///< of a way that is a whole number of steps

  /// Of a way between two times as they are written, which far from 0 is more than that.
  S rounding_of(const S& end) const {
    using gauss::integrate::magnitude;
    return 2 * gauss::Math<S>::epsilon() * std::max(magnitude(t_), magnitude(end));
  }

  bool is_running() const { return progress_.outcome == Outcome::running; }

  void step(const S& t, const S& h, const S& next) {
    progress_.outcome = settings_.before_step(progress_.steps);
    if (!is_running()) return;
    const gauss::integrate::StepResult result = stepper_.step(model_, t, h, state_);
    progress_.calls += calls(stepper_, 0);
    if (result.status != gauss::Status::ok) progress_.status = result.status;
    if (!result.is_taken()) return stop(result.outcome);
    t_ = next;
    ++progress_.steps;
    if (result.status == gauss::Status::dependent_constraints) ++progress_.with_fewer_constraints;
    if (projects_) project();
  }

  void stop(StepOutcome outcome) {
    progress_.outcome = Outcome::model_failed;
    if (outcome == StepOutcome::unsuitable) {
      progress_.outcome = Outcome::bad_settings;
      progress_.why = "the method takes only models whose accelerations depend on coordinates alone";
    }
    if (outcome == StepOutcome::not_converged)
      progress_.why = "the equations of the implicit method were not solved: the step is too long";
  }

  void project() {
    const gauss::Status status = model_.projection(t_, state_);
    if (gauss::integrate::is_motion_known(status)) return;
    progress_.status = status;
    progress_.outcome = Outcome::constraints_lost;
  }

  template <class Any>
  auto calls(const Any& stepper, int) const -> decltype(stepper.calls_of_last_step()) {
    return stepper.calls_of_last_step();
  }
  template <class Any>
  long calls(const Any&, long) const {
    return calls_in_a_step_;
  }

  Model model_;
  Stepper stepper_;
  typename Model::State state_;
  S t_, step_;
  gauss::simulate::Settings<S> settings_;
  bool projects_;
  long calls_in_a_step_;
  Progress<S> progress_;
};

}  // namespace gausssim
