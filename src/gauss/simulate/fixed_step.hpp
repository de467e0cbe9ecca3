// Integration with steps of one length, by any stepper: for long runs, whose errors must not grow, and for real time.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_FIXED_STEP_HPP
#define GAUSS_SIMULATE_FIXED_STEP_HPP

#include <cstdint>
#include <utility>

#include "gauss/integrate/step_result.hpp"
#include "gauss/integrate/time_grid.hpp"

namespace gauss::simulate {

/// Time is start + k step with a whole k: it does not drift. After a step that could not be taken, the run stays where it was.
template <class Model, class Stepper>
class FixedStep {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;

  /// `step` is in units of time, negative to go back.
  FixedStep(const Model& model, const State& start, const Scalar& step, const Scalar& start_time = 0,
            Stepper stepper = Stepper())
      : model_(model), stepper_(std::move(stepper)), grid_(start_time, step), state_(start) {}

  /// Takes `count` steps, unless one cannot be taken: false then, and last() says why.
  bool advance(std::int64_t count) {
    return advance(count, [](const Scalar&, const State&) {});
  }

  /// `on_step(t, state)` sees each state that was reached.
  template <class OnStep>
  bool advance(std::int64_t count, OnStep&& on_step) {
    for (std::int64_t k = 0; k < count; ++k) {
      if (!last_.is_taken()) return false;
      last_ = stepper_.step(model_, time(), grid_.step(), state_);
      if (!last_.is_taken()) return false;
      ++steps_;
      on_step(time(), state_);
    }
    return last_.is_taken();
  }

  /// The same steps backwards from here, with what the stepper remembers.
  void turn_back() {
    grid_ = integrate::TimeGrid<Scalar>(time(), -grid_.step());
    steps_ = 0;
  }

  Scalar time() const { return grid_.at(steps_); }
  std::int64_t steps() const { return steps_; }
  const State& state() const { return state_; }
  const integrate::StepResult& last() const { return last_; }
  const Stepper& stepper() const { return stepper_; }

 private:
  Model model_;
  Stepper stepper_;
  integrate::TimeGrid<Scalar> grid_;
  State state_;
  std::int64_t steps_ = 0;  ///< since the start of the grid
  integrate::StepResult last_;
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_FIXED_STEP_HPP
