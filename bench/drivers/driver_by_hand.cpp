// What a person writes who integrates an emitted model by Boost.Odeint: a loop over a controlled stepper. A library of its own, which driver.cpp
// loads; see bench/driver.py.

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "double_pendulum.hpp"
#include "driver_counts.hpp"
#include "gauss/integrate/prince_dormand87.hpp"

namespace {

namespace odeint = boost::numeric::odeint;
namespace model = gauss::double_pendulum;

constexpr std::size_t n = 4;
using Array = std::array<double, n>;

struct Given {
  model::Parameters<double> parameters{};
  model::Inputs<double> inputs{};
  model::Prepared<double> prepared = model::prepare(parameters);
};

struct System {
  const Given& given;
  long& calls;
  Array* sizes = nullptr;  ///< of states, where somebody asks for them

  void operator()(const Array& x, Array& rates, double t) const {
    ++calls;
    if (sizes != nullptr) {
      for (std::size_t i = 0; i < n; ++i) (*sizes)[i] = std::max((*sizes)[i], std::abs(x[i]));
    }
    model::State<double> state;
    model::Derivative<double> derivative;
    std::copy(x.begin(), x.end(), state.values);
    model::rhs(t, state, given.inputs, given.prepared, derivative);
    std::copy(derivative.values, derivative.values + n, rates.begin());
  }
};

/// The measure that gauss-sim has: the largest size so far. Then both take the same steps.
class ToLargestSize {
 public:
  ToLargestSize(double tolerance, Array& within) : tolerance_(tolerance), within_(&within) {}

  template <class Algebra>
  double error(Algebra&, const Array&, const Array&, const Array& errors, double) {
    constexpr double k_least = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
    constexpr double k_places = 64 * std::numeric_limits<double>::epsilon();
    Array size;
    for (std::size_t i = 0; i < n; ++i) size[i] = std::max(largest_[i], (*within_)[i]);
    // Angles and their rates, whose rounding is that of the largest; of angles at least that of 1.
    const double angles = std::max({size[0], size[1], 1.0}), rates = std::max(size[2], size[3]);
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double allowed = k_least + tolerance_ * size[i] + k_places * (i < 2 ? angles : rates);
      worst = std::max(worst, std::abs(errors[i]) / allowed);
    }
    return worst;
  }

  void grow(const Array& x) {
    for (std::size_t i = 0; i < n; ++i) largest_[i] = std::max(largest_[i], std::abs(x[i]));
  }

 private:
  double tolerance_;
  Array* within_;
  Array largest_{};
};

/// Odeint copies checkers.
struct Borrowed {
  ToLargestSize* checker;

  template <class Algebra>
  double error(Algebra& algebra, const Array& x, const Array& rates, const Array& errors, double dt) const {
    return checker->error(algebra, x, rates, errors, dt);
  }
};

template <class Method>
constexpr bool k_keeps_last_stage =
    std::is_same_v<typename Method::stepper_category, odeint::explicit_error_stepper_fsal_tag>;

/// The same steps as gauss-sim.
template <class Method>
Counts with_same_steps(double tolerance, double end, Array& x) {
  const Given given;
  Counts counts;
  Array within{}, rates{}, next{}, last{};
  ToLargestSize checker(tolerance, within);
  checker.grow(x);
  const System system{given, counts.calls, &within};
  static const Method k_blank;
  odeint::controlled_runge_kutta<Method, Borrowed> stepper(Borrowed{&checker},
                                                           odeint::default_step_adjuster<double, double>(), k_blank);
  double t = 0, step = std::pow(tolerance, 1.0 / Method::order_value) * end;
  bool has_rates = false;
  while (t < end) {
    within.fill(0);
    if (!has_rates) system(x, rates, t);
    for (;;) {
      double dt = std::min(step, end - t), time = t;
      const double tried = dt;
      odeint::controlled_step_result result;
      if constexpr (k_keeps_last_stage<Method>) {
        result = stepper.try_step(std::cref(system), x, rates, time, next, last, dt);
      } else {
        result = stepper.try_step(std::cref(system), x, rates, time, next, dt);
      }
      step = dt;
      if (result == odeint::success) {
        t = tried == end - t ? end : t + tried;
        break;
      }
      ++counts.rejected;
      within.fill(0);
    }
    has_rates = k_keeps_last_stage<Method>;
    rates = last;
    x = next;
    checker.grow(x);
    ++counts.steps;
  }
  return counts;
}

/// As Odeint offers it.
template <class Method>
Counts with_usual_steps(double tolerance, double end, Array& x) {
  const Given given;
  Counts counts;
  const System system{given, counts.calls};
  using Checker = odeint::default_error_checker<double, odeint::array_algebra, odeint::default_operations>;
  odeint::controlled_runge_kutta<Method, Checker> stepper(Checker(tolerance, tolerance));
  double t = 0, dt = std::pow(tolerance, 1.0 / Method::order_value) * end;
  while (t < end) {
    const bool arrives = t + dt >= end;
    if (arrives) dt = end - t;
    if (stepper.try_step(system, x, t, dt) != odeint::success) {
      ++counts.rejected;
      continue;
    }
    ++counts.steps;
    if (arrives) break;
  }
  return counts;
}

Counts with_rk4(double step, double end, Array& x) {
  const Given given;
  Counts counts;
  const System system{given, counts.calls};
  odeint::runge_kutta4<Array> stepper;
  counts.steps = std::lround(end / step);
  for (long k = 0; k < counts.steps; ++k)
    stepper.do_step(system, x, static_cast<double>(k) * (end / static_cast<double>(counts.steps)),
                    end / static_cast<double>(counts.steps));
  return counts;
}

}  // namespace

#define LOOP(name, call)                                                                                     \
  extern "C" __attribute__((visibility("default"))) Counts name(double setting, double end, double* state) { \
    Array x;                                                                                                 \
    std::copy_n(state, n, x.begin());                                                                        \
    const Counts counts = call(setting, end, x);                                                             \
    std::copy_n(x.begin(), n, state);                                                                        \
    return counts;                                                                                           \
  }

LOOP(same_fehlberg78, with_same_steps<odeint::runge_kutta_fehlberg78<Array>>)
LOOP(same_prince87, (with_same_steps<gauss::integrate::PrinceDormand87<Array, double>>))
LOOP(same_dopri5, with_same_steps<odeint::runge_kutta_dopri5<Array>>)
LOOP(same_rk4, with_rk4)
LOOP(usual_fehlberg78, with_usual_steps<odeint::runge_kutta_fehlberg78<Array>>)
LOOP(usual_prince87, (with_usual_steps<gauss::integrate::PrinceDormand87<Array, double>>))
LOOP(usual_dopri5, with_usual_steps<odeint::runge_kutta_dopri5<Array>>)
