#pragma once
// Steps of one length, by a stepper in the sense of gauss/integrate/explicit_stepper.hpp.

#include <cmath>
#include <utility>

#include "gauss/integrate/step_result.hpp"
#include "gauss/integrate/time_grid.hpp"
#include "sim/drive/integrator.hpp"

namespace gausssim {

/// Each way to `advance_to` is divided into equal steps, none longer than `step`.
template <class S, class Stepper>
class Fixed final : public Integrator<S> {
 public:
  using Array = Numbers<S>;
  using Model = MotionModel<S>;

  Fixed(const Model& model, const Array& start, const S& t, const S& step, bool projects, long calls_in_a_step,
        Stepper stepper = Stepper())
      : model_(model),
        stepper_(std::move(stepper)),
        state_{start},
        t_(t),
        step_(step),
        projects_(projects),
        calls_in_a_step_(calls_in_a_step) {
    if (projects_) project();
  }

  bool advance_to(const S& end) override {
    using std::ceil;
    const S way = end - t_;
    if (!(way > S(0)) || !is_running()) return is_running() && way == S(0);
    const auto count = static_cast<long>(ceil(way / step_));
    const gauss::integrate::TimeGrid<S> grid(t_, way / S(count));
    for (long k = 0; k < count && is_running(); ++k)
      step(grid.at(k), grid.step(), k + 1 == count ? end : grid.at(k + 1));
    return is_running();
  }

  S time() const override { return t_; }
  Array state() const override { return state_.values; }
  Progress<S> progress() const override { return progress_; }

 private:
  bool is_running() const { return progress_.outcome == gauss::simulate::Outcome::running; }

  void step(const S& t, const S& h, const S& next) {
    const gauss::integrate::StepResult result = stepper_.step(model_, t, h, state_);
    progress_.calls += calls_in_a_step_;
    if (result.status != gauss::Status::ok) progress_.status = result.status;
    if (!result.is_taken()) {
      progress_.outcome = gauss::simulate::Outcome::model_failed;
      return;
    }
    t_ = next;
    ++progress_.steps;
    if (result.status == gauss::Status::dependent_constraints) ++progress_.with_fewer_constraints;
    if (projects_) project();
  }

  void project() {
    const gauss::Status status = model_.projection(t_, state_);
    if (gauss::integrate::is_motion_known(status)) return;
    progress_.status = status;
    progress_.outcome = gauss::simulate::Outcome::constraints_lost;
  }

  Model model_;
  Stepper stepper_;
  typename Model::State state_;
  S t_, step_;
  bool projects_;
  long calls_in_a_step_;
  Progress<S> progress_;
};

}  // namespace gausssim
