// Steps by power series of the motion, of models that were generated with `taylor`: any order, and the motion within a step with it.
// SPDX-License-Identifier: MIT
//
// Order and step follow Jorba and Zou, A software package for the numerical integration of ODEs by means of high-order Taylor methods, Experimental
// Mathematics 14 (2005) 99.
#ifndef GAUSS_INTEGRATE_TAYLOR_HPP
#define GAUSS_INTEGRATE_TAYLOR_HPP

#include <cmath>
#include <cstddef>
#include <type_traits>

#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

namespace detail {

/// Components by as many at a time as vectors take, so that sums stay in registers from one order to the next; the last ones may be done twice. `each(lanes, first)`: with
/// lanes a constant.
template <std::size_t n, class Each>
void in_lanes(const Each& each) {
  constexpr std::size_t k_lanes = n >= 8 ? 8 : n >= 4 ? 4 : n;
  std::size_t first = 0;
  for (; first + k_lanes <= n; first += k_lanes) each(std::integral_constant<std::size_t, k_lanes>{}, first);
  if constexpr (n % k_lanes != 0) {
    constexpr std::size_t k_rest = n % k_lanes > 4 ? k_lanes : 4;
    each(std::integral_constant<std::size_t, k_rest>{}, n - k_rest);
  }
}

}  // namespace detail

/// The state `h` after the time of a series, of its first `order` orders, by Horner's rule.
template <class Series, class S, class State>
void state_of_series(const Series& series, int order, const S& h, State& state) {
  constexpr std::size_t n = sizeof(state.values) / sizeof(state.values[0]);
  const S step = h;
  detail::in_lanes<n>([&](auto lanes, std::size_t first) {
    S x[lanes];
    for (std::size_t i = 0; i < lanes; ++i) x[i] = series.values[order][first + i];
    for (int k = order - 1; k >= 0; --k) {
      for (std::size_t i = 0; i < lanes; ++i) x[i] = x[i] * step + series.values[k][first + i];
    }
    for (std::size_t i = 0; i < lanes; ++i) state.values[first + i] = x[i];
  });
}

template <class Series, class S, class State>
void state_of_series(const Series& series, const S& h, State& state) {
  state_of_series(series, series.order, h, state);
}

/// Its rate there.
template <class Series, class S, std::size_t n>
void rate_of_series(const Series& series, const S& h, S (&rate)[n]) {
  const S step = h;
  detail::in_lanes<n>([&](auto lanes, std::size_t first) {
    S factor = S(series.order);
    S x[lanes];
    for (std::size_t i = 0; i < lanes; ++i) x[i] = factor * series.values[series.order][first + i];
    for (int k = series.order - 1; k > 0; --k) {
      factor = factor - S(1);
      for (std::size_t i = 0; i < lanes; ++i) x[i] = x[i] * step + factor * series.values[k][first + i];
    }
    for (std::size_t i = 0; i < lanes; ++i) rate[first + i] = x[i];
  });
}

/// Order at which a step of a given relative error takes the least work for the time that it spans, between 2 and `most`. A term of order p is e^-2p where a step is the e^2-th part of the radius
/// of convergence: -ln(tolerance)/2 is best where work grows with the square of the order. Here most of it grows with the order alone, and longer
/// steps of more orders take less.
inline int taylor_order(double tolerance, int most) {
  const double order = 1 - 0.65 * std::log(tolerance);
  return order < 2 ? 2 : order < most ? static_cast<int>(std::ceil(order)) : most;
}

/// A stepper of one order for steps of any length; see gauss/integrate/explicit_stepper.hpp. `Series` is the model's TaylorSeries<Scalar>. Inputs are those at the
/// beginning of a step.
template <class Model, class Series>
class Taylor {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;

  explicit Taylor(int order = 20) : order_(order) {}

  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    const StepResult result = result_of(model.series(t, state, order_, series_));
    if (result.status != Status::ok) return {StepOutcome::model_failed, result.status};
    state_of_series(series_, h, state);
    return result;
  }

  /// Of the last step, from its beginning.
  const Series& series() const { return series_; }

 private:
  int order_;
  Series series_{};
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_TAYLOR_HPP
