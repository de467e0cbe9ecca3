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

/// Sums of a series at `h`, of which `at(order, i).numbers` are the terms: even orders and odd ones are sums of their own, which wait for each other in one place only. The order 0 is
/// added last, so that the result is rounded once at its own size. Written as packs, sums stay in registers; `put(i, sum)`.
template <class V, std::size_t... places, class H, class At, class Put>
GAUSS_INLINED void sum_terms(int order, const H& h, const At& at, const Put& put) {
  const H square = h * h;
  const auto each = [](const auto& what) {
    std::size_t group = 0;
    (what(group++, places), ...);
  };
  V last[] = {at(order, places).numbers...}, other[] = {at(order - 1, places).numbers...};
  int k = order - 2;
  for (; k > 1; k -= 2) {
    each([&](std::size_t g, std::size_t i) { last[g] = last[g] * square + at(k, i).numbers; });
    each([&](std::size_t g, std::size_t i) { other[g] = other[g] * square + at(k - 1, i).numbers; });
  }
  if (k == 1) {
    each([&](std::size_t g, std::size_t i) { last[g] = (last[g] * square + at(1, i).numbers) + h * other[g]; });
  } else {
    each([&](std::size_t g, std::size_t) { last[g] = other[g] + h * last[g]; });
  }
  each([&](std::size_t g, std::size_t i) { put(i, at(0, i).numbers + h * last[g]); });
}

/// Of these components, at all times that `Lanes` has a number for.
template <std::size_t... components, class Series, class Lanes>
void sum_in_lanes(const Series& series, const Lanes& h, Lanes* result) {
  const auto at = [&](int k, std::size_t i) { return Lanes(series.values[k][i]); };
  sum_terms<Lanes, components...>(series.order, h, at, [&](std::size_t i, const Lanes& sum) { result[i] = sum; });
}

/// As many together as there are registers for, of at least four; the last four may begin within those before.
template <std::size_t n, std::size_t first = 0, class Series, class Lanes>
void sum_all_in_lanes(const Series& series, const Lanes& h, Lanes* result) {
  constexpr std::size_t at = first + 4 <= n ? first : n - 4;
  sum_in_lanes<at, at + 1, at + 2, at + 3>(series, h, result);
  if constexpr (first + 4 < n) sum_all_in_lanes<n, first + 4>(series, h, result);
}

#if defined(__GNUC__)
/// Sums of four components at a time stay in registers as vectors only: compilers keep arrays of numbers in memory, and in parts of other sizes.
template <class S>
struct Four {
  typedef S type __attribute__((vector_size(4 * sizeof(S))));
  /// Of numbers wherever they are. A type of its own: clang++ forgets the alignment of a typedef where it is a template argument.
  struct __attribute__((packed, may_alias, aligned(alignof(S)))) Placed {
    type numbers;
  };
};

template <class S>
inline constexpr bool has_four = std::is_same_v<S, double> || std::is_same_v<S, float>;

/// Of the components from each of `begin` on.
template <std::size_t... begin, class Series, class S>
void sum_in_fours(const Series& series, int order, S h, S* result) {
  using V = typename Four<S>::type;
  using Placed = typename Four<S>::Placed;
  const auto at = [&](int k, std::size_t i) -> const Placed& {
    return *reinterpret_cast<const Placed*>(&series.values[k][i]);
  };
  sum_terms<V, begin...>(order, h, at,
                         [&](std::size_t i, const V& sum) { reinterpret_cast<Placed*>(result + i)->numbers = sum; });
}

/// As many together as there are registers for; the last four may begin within those before.
template <std::size_t n, std::size_t first = 0, class Series, class S>
void sum_all_in_fours(const Series& series, int order, const S& h, S* result) {
  constexpr auto at = [](std::size_t group) { return first + 4 * group + 4 <= n ? first + 4 * group : n - 4; };
  constexpr std::size_t left = n - first;
  if constexpr (left > 12) {
    sum_in_fours<at(0), at(1), at(2), at(3)>(series, order, h, result);
    if constexpr (left > 16) sum_all_in_fours<n, first + 16>(series, order, h, result);
  } else if constexpr (left > 8) {
    sum_in_fours<at(0), at(1), at(2)>(series, order, h, result);
  } else if constexpr (left > 4) {
    sum_in_fours<at(0), at(1)>(series, order, h, result);
  } else {
    sum_in_fours<at(0)>(series, order, h, result);
  }
}
#else
template <class S>
inline constexpr bool has_four = false;
#endif

}  // namespace detail

/// The state `h` after the time of a series, of its first `order` orders, at least 2, by Horner's rule.
template <class Series, class S, class State>
void state_of_series(const Series& series, int order, const S& h, State& state) {
  constexpr std::size_t n = sizeof(state.values) / sizeof(state.values[0]);
  if constexpr (detail::has_four<S> && n >= 4) {
    detail::sum_all_in_fours<n>(series, order, h, state.values);
  } else {
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
}

template <class Series, class S, class State>
void state_of_series(const Series& series, const S& h, State& state) {
  state_of_series(series, series.order, h, state);
}

/// The states at several times, of which each number of `h` has one: what state_of_series finds for each of them, to the bit. `Lanes` has arithmetic, and is made of its
/// `numbers`, a vector.
template <class Series, class Lanes, class State>
void states_of_series(const Series& series, const Lanes& h, State& state) {
  using S = std::remove_cv_t<std::remove_reference_t<decltype(series.values[0][0])>>;
  constexpr std::size_t n = sizeof(state.values) / sizeof(state.values[0]);
  if constexpr (detail::has_four<S> && n >= 4) {
    detail::sum_all_in_lanes<n>(series, h, state.values);
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      Lanes x(series.values[series.order][i]);
      for (int k = series.order - 1; k >= 0; --k) x = x * h + Lanes(series.values[k][i]);
      state.values[i] = x;
    }
  }
}

/// Its rate there.
template <class Series, class S, class Rate>
void rate_of_series(const Series& series, const S& h, Rate& rate) {
  constexpr std::size_t n = sizeof(Rate) / sizeof(S);
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
/// of convergence: -ln(tolerance)/2 is best where work grows with the square of the order, -ln(tolerance) where it grows with the order. Sums over
/// lower orders are the lesser part here.
inline int taylor_order(double tolerance, int most) {
  const double order = 1 - 0.8 * std::log(tolerance);
  return order < 2 ? 2 : order < most ? static_cast<int>(std::ceil(order)) : most;
}

/// A whole power, by squaring.
template <class S>
S power(S x, int exponent) {
  S result(1);
  for (; exponent > 0; exponent /= 2, x = x * x) result = exponent % 2 == 1 ? S(result * x) : result;
  return result;
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
