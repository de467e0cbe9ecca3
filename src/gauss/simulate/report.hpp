// What simulations with an estimate of their error are told, and what they say.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_REPORT_HPP
#define GAUSS_SIMULATE_REPORT_HPP

#include <cstddef>
#include <limits>

namespace gauss::simulate {

enum class Outcome {
  running,
  model_failed,    ///< the model's status at the state reached is not ok
  step_too_small,  ///< the model's status or the error asks for steps below rounding of the time
  too_many_steps,
  constraints_lost,  ///< projection moves the state by more than errors of steps explain, however short the steps
  interrupted,       ///< Settings::ends said so
  bad_settings,      ///< a setting or the time of the start is no number or out of its range; nothing was integrated
  no_regime,         ///< contacts and friction leave no motion, as of Painleve's rod
  too_many_events,   ///< they change without end at one instant
};

constexpr const char* name(Outcome outcome) noexcept {
  return outcome == Outcome::running           ? "running"
         : outcome == Outcome::model_failed    ? "model failed"
         : outcome == Outcome::step_too_small  ? "step too small"
         : outcome == Outcome::too_many_steps  ? "too many steps"
         : outcome == Outcome::interrupted     ? "interrupted"
         : outcome == Outcome::bad_settings    ? "bad settings"
         : outcome == Outcome::no_regime       ? "no regime"
         : outcome == Outcome::too_many_events ? "too many events"
                                               : "constraints lost";
}

template <class Scalar>
struct Settings {
  Scalar tolerance = Scalar(1e-12);  ///< error of one step, relative to the scale of each component; above 0
  /// The scale is the largest size so far, but no less than this, in the component's unit. 0: rounding is the limit, whatever the unit.
  Scalar smallest_scale = 0;
  Scalar smallest_speed = 0;  ///< the same of speeds; 0: smallest_scale. See docs/simulation.md, stiff models
  Scalar first_step = 0;      ///< 0: chosen from the rates at the start
  Scalar longest_step =
      0;  ///< 0: none. A pulse that is shorter than a step may lie between the times at which it looks
  long most_steps = 10'000'000;
  bool (*ends)() = nullptr;  ///< asked before each step: whether none is taken any more
  bool project = true;
  /// Places near which rates lose their digits, as change points of linkages, are crossed, or end the motion. Not for models whose rates do so for another reason.
  bool crosses_lost_digits = true;
  Scalar most_projected = 1000;  ///< a projection that moves a component by more tolerances is refused

  Scalar least_speed() const { return smallest_speed > Scalar(0) ? smallest_speed : smallest_scale; }

  /// After so many steps, whether there is another one.
  Outcome before_step(long steps) const {
    if (ends != nullptr && ends()) return Outcome::interrupted;
    return steps >= most_steps ? Outcome::too_many_steps : Outcome::running;
  }

  /// Whether each is within its range; what is no number is in none. A step cannot be shorter than 0, nor an error smaller.
  bool are_usable() const {
    const Scalar zero = 0;
    return tolerance > zero && tolerance - tolerance == zero && smallest_scale >= zero && smallest_speed >= zero &&
           first_step >= zero && longest_step >= zero && most_steps >= 0 && most_projected >= zero;
  }
};

template <class Status, class Scalar = double>
struct Report {
  Outcome outcome = Outcome::running;
  Status status{};    ///< the model's last one that was not ok; ok if there was none
  long steps = 0;     ///< accepted
  long rejected = 0;  ///< by the estimate of the error, or by a status other than ok
  long with_fewer_constraints =
      0;  ///< of the accepted: rhs said dependent_constraints, and the motion is that of the rest
  long crossings =
      0;  ///< of the accepted: taken over a place where constraints nearly lose their rank, to half of the digits that were asked for
  long calls = 0;      ///< of rhs
  long jacobians = 0;  ///< emitted ones that an implicit method asked for

  /// By how much projection has moved the start onto the constraints: the largest move of a component, in its own unit.
  Scalar start_moved = 0;
  std::size_t start_component = 0;  ///< of the state, which moved so

  template <class State>
  void compare_start(const State& before, const State& after, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar change = after.values[i] - before.values[i];
      const Scalar move = change < Scalar(0) ? -change : change;
      if (move <= start_moved) continue;
      start_moved = move;
      start_component = i;
    }
  }
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_REPORT_HPP
