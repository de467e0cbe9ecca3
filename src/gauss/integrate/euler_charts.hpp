// Euler angles without a pole: a stepper, and a model for simulations with an estimate of their error, that change between two charts of an attitude
// (gauss/integrate/euler_chart.hpp).
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_EULER_CHARTS_HPP
#define GAUSS_INTEGRATE_EULER_CHARTS_HPP

#include <array>
#include <type_traits>
#include <utility>

#include "gauss/integrate/euler_chart.hpp"
#include "gauss/integrate/model_decorator.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

template <class Scalar>
struct ChartReport {
  long switches = 0;
  Scalar last = 0;  ///< time of the last one
};

/// Steps by `Inner`. Before a step the chart is changed where |sin| (of sequences such as zyx: |cos|) of the second angle is below a limit. The outermost
/// of all decorators, since a body with axes of its own is another model in the other chart: `Prepared` is then that of the model, for C = 1 and for C a
/// quarter turn about axis p. In the model the body is on a frame behind the angles,
/// `{parent: carried, orientation: {axis: x, angle: behind}}`, and `behind` is a parameter, 0 or pi/2.
template <class Inner, class Sequence, class Prepared = SameInBothCharts>
class EulerCharts {
 public:
  using Scalar = typename Inner::Scalar;
  using State = typename Inner::State;
  using Chart = EulerChart<State, Sequence>;
  using PreparedInCharts = std::array<Prepared, 2>;
  static constexpr std::size_t p = Chart::p;
  static constexpr double k_behind = Chart::k_behind;

  explicit EulerCharts(const EulerPlaces& places, Inner inner = Inner(), const PreparedInCharts& prepared = {},
                       const Scalar& limit = Scalar(Chart::k_limit))
      : chart_(places, limit), inner_(std::move(inner)), prepared_(prepared) {}

  /// As of EulerChart.
  void place(const Rotation<Scalar>& attitude, const Vector3<Scalar>& angular_velocity, State& state) {
    chart_.place(attitude, angular_velocity, state);
  }

  template <class Model>
  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    constexpr double k_half_turn = 3.14159265358979323846;
    State trial = state;
    Chart chart = chart_;
    const bool is_changed = chart.change(trial);
    chart.wrap(Scalar(k_half_turn), trial);
    const StepResult result = step_in_chart(chart.is_turned(), model, t, h, trial);
    if (!result.is_taken()) return result;
    if (is_changed) {
      ++report_.switches;
      report_.last = t;
    }
    chart_ = chart;
    state = trial;
    return result;
  }

  /// Of the body, from a state in the chart that is in force.
  Rotation<Scalar> attitude(const State& state) const { return chart_.attitude(state); }
  /// In the axes of space.
  Vector3<Scalar> angular_velocity(const State& state) const { return chart_.angular_velocity(state); }
  /// Whether C is the quarter turn, and not 1.
  bool is_turned() const { return chart_.is_turned(); }
  /// C of the chart that is in force.
  Rotation<Scalar> behind() const { return chart_.behind(); }
  const ChartReport<Scalar>& report() const { return report_; }
  const Inner& inner() const { return inner_; }

 private:
  template <class Model>
  StepResult step_in_chart(bool is_turned, const Model& model, const Scalar& t, const Scalar& h, State& state) {
    if constexpr (std::is_same_v<Prepared, SameInBothCharts>) {
      return inner_.step(model, t, h, state);
    } else {
      return inner_.step(model.with(prepared_[is_turned ? 1 : 0]), t, h, state);
    }
  }

  Chart chart_;
  Inner inner_;
  PreparedInCharts prepared_;
  ChartReport<Scalar> report_;
};

/// The same for simulations with an estimate of their error, which take no steppers: the model `Base`, a BoundModel, that writes its state in the other
/// chart between their steps. `Prepared` as of EulerCharts.
template <class Base, class Sequence, class Prepared = SameInBothCharts>
class InEulerCharts : public ModelDecorator<InEulerCharts<Base, Sequence, Prepared>, Base> {
  using Decorator = ModelDecorator<InEulerCharts<Base, Sequence, Prepared>, Base>;

 public:
  using typename Decorator::Scalar;
  using typename Decorator::State;
  using Chart = EulerChart<State, Sequence>;

  explicit InEulerCharts(const Base& base, const EulerPlaces& places, const std::array<Prepared, 2>& prepared = {},
                         const Scalar& limit = Scalar(Chart::k_limit))
      : bases_(in_charts(base, prepared)), chart_(places, limit) {}

  /// As of EulerChart.
  void place(const Rotation<Scalar>& attitude, const Vector3<Scalar>& angular_velocity, State& state) {
    chart_.place(attitude, angular_velocity, state);
  }

  /// Between steps: into the other chart near the pole of this one, and back by whole turns, which multistep methods begin anew after, only where an angle is beyond one.
  bool rewrite(State& state) {
    constexpr double k_turn = 6.28318530717958647693;
    const bool is_changed = chart_.change(state);
    if (is_changed) ++switches_;
    return chart_.wrap(Scalar(k_turn), state) || is_changed;
  }

  Rotation<Scalar> attitude(const State& state) const { return chart_.attitude(state); }
  Vector3<Scalar> angular_velocity(const State& state) const { return chart_.angular_velocity(state); }
  const Chart& chart() const { return chart_; }
  /// Changes of the chart so far.
  long switches() const { return switches_; }
  const Base& base() const { return bases_[chart_.is_turned() ? 1 : 0]; }

 private:
  static std::array<Base, 2> in_charts(const Base& base, [[maybe_unused]] const std::array<Prepared, 2>& prepared) {
    if constexpr (std::is_same_v<Prepared, SameInBothCharts>) {
      return {base, base};
    } else {
      return {base.with(prepared[0]), base.with(prepared[1])};
    }
  }

  std::array<Base, 2> bases_;
  Chart chart_;
  long switches_ = 0;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_EULER_CHARTS_HPP
