#pragma once
// gauss::Dual<S, N>: a number with its derivatives by N variables, so that emitted models give their own derivatives.
// SPDX-License-Identifier: MIT-0
//
// Forward mode (Wengert 1964): a value and N tangents, which follow from the chain rule, exactly but for rounding. S is any
// scalar of emitted models, a batch or another Dual (for second derivatives) included:
//
//     using S = gauss::Dual<double, 2>;
//     state.theta() = S::variable(0.5, 0);      // ∂/∂theta is tangent[0]
//     state.theta_dot() = S::variable(0.0, 1);
//     … rhs(S(0), state, inputs, prepared, derivative) …
//     double slope = derivative.theta_ddot().tangent[0];

#include "gauss/math.hpp"

namespace gauss {

template <class S, int N>
struct Dual {
  static_assert(N > 0, "a dual number has at least one tangent");

  S value{};
  S tangent[N]{};

  GAUSS_FUNCTION Dual() noexcept {}
  /// A constant: all tangents are zero.
  GAUSS_FUNCTION explicit Dual(const S& number) noexcept : value(number) { clear(); }
  template <class Number>
  GAUSS_FUNCTION explicit Dual(const Number& number) noexcept : value(static_cast<S>(number)) {
    clear();
  }

  /// The variable by which `tangent[index]` of everything that follows is the derivative.
  GAUSS_FUNCTION static Dual variable(const S& number, int index) noexcept {
    Dual result(number);
    result.tangent[index] = S(1);
    return result;
  }

  GAUSS_FUNCTION friend Dual operator-(const Dual& a) noexcept {
    Dual result;
    result.value = -a.value;
    for (int i = 0; i < N; ++i) result.tangent[i] = -a.tangent[i];
    return result;
  }
  GAUSS_FUNCTION friend Dual operator+(const Dual& a, const Dual& b) noexcept {
    Dual result;
    result.value = a.value + b.value;
    for (int i = 0; i < N; ++i) result.tangent[i] = a.tangent[i] + b.tangent[i];
    return result;
  }
  GAUSS_FUNCTION friend Dual operator-(const Dual& a, const Dual& b) noexcept {
    Dual result;
    result.value = a.value - b.value;
    for (int i = 0; i < N; ++i) result.tangent[i] = a.tangent[i] - b.tangent[i];
    return result;
  }
  GAUSS_FUNCTION friend Dual operator*(const Dual& a, const Dual& b) noexcept {
    Dual result;
    result.value = a.value * b.value;
    for (int i = 0; i < N; ++i) result.tangent[i] = a.tangent[i] * b.value + a.value * b.tangent[i];
    return result;
  }
  GAUSS_FUNCTION friend Dual operator/(const Dual& a, const Dual& b) noexcept {
    const S inverse = S(1) / b.value;
    Dual result;
    result.value = a.value / b.value;
    for (int i = 0; i < N; ++i) result.tangent[i] = (a.tangent[i] - result.value * b.tangent[i]) * inverse;
    return result;
  }

 private:
  GAUSS_FUNCTION void clear() noexcept {
    for (S& each : tangent) each = S(0);
  }
};

namespace dual_detail {

/// Whether a number, with whatever derivatives it has itself, is zero.
template <class S>
struct Zero {
  GAUSS_FUNCTION static auto is(const S& x) noexcept { return x == S(0); }
};
template <class S, int N>
struct Zero<Dual<S, N>> {
  GAUSS_FUNCTION static auto is(const Dual<S, N>& x) noexcept {
    auto all = Zero<S>::is(x.value);
    for (int i = 0; i < N; ++i) all = all && Zero<S>::is(x.tangent[i]);
    return all;
  }
};

/// f(a) with its value and f'(a).
template <class S, int N>
GAUSS_FUNCTION Dual<S, N> chained(const Dual<S, N>& a, const S& value, const S& slope) noexcept {
  Dual<S, N> result;
  result.value = value;
  for (int i = 0; i < N; ++i) result.tangent[i] = slope * a.tangent[i];
  return result;
}

/// What a variable adds through a slope that may be infinite or not defined: nothing where the variable does not change, so
/// that the root of a constant zero is a constant.
template <class S>
GAUSS_FUNCTION S added(const S& slope, const S& tangent) noexcept {
  return Math<S>::select(Zero<S>::is(tangent), S(0), slope * tangent);
}

/// `chained` for functions whose slope has no bound.
template <class S, int N>
GAUSS_FUNCTION Dual<S, N> chained_where_it_moves(const Dual<S, N>& a, const S& value, const S& slope) noexcept {
  Dual<S, N> result;
  result.value = value;
  for (int i = 0; i < N; ++i) result.tangent[i] = added(slope, a.tangent[i]);
  return result;
}

}  // namespace dual_detail

/// Conditions compare values; selections take value and tangents together, and the derivative is that of the case that holds.
template <class T, int N>
struct Math<Dual<T, N>> {
  using S = Dual<T, N>;
  using Bool = typename Math<T>::Bool;
  using Status = typename Math<T>::Status;

  GAUSS_FUNCTION static S sin(const S& x) noexcept {
    T sine, cosine;
    Math<T>::sincos(x.value, sine, cosine);
    return dual_detail::chained(x, sine, cosine);
  }
  GAUSS_FUNCTION static S cos(const S& x) noexcept {
    T sine, cosine;
    Math<T>::sincos(x.value, sine, cosine);
    return dual_detail::chained(x, cosine, -sine);
  }
  GAUSS_FUNCTION static void sincos(const S& x, S& sine, S& cosine) noexcept {
    T s, c;
    Math<T>::sincos(x.value, s, c);
    const S argument = x;  // which may be one of the results
    sine = dual_detail::chained(argument, s, c);
    cosine = dual_detail::chained(argument, c, -s);
  }
  GAUSS_FUNCTION static S tan(const S& x) noexcept {
    const T value = Math<T>::tan(x.value);
    return dual_detail::chained(x, value, T(1) + value * value);
  }
  GAUSS_FUNCTION static S asin(const S& x) noexcept {
    return dual_detail::chained_where_it_moves(x, Math<T>::asin(x.value), T(1) / leg(x.value));
  }
  GAUSS_FUNCTION static S acos(const S& x) noexcept {
    return dual_detail::chained_where_it_moves(x, Math<T>::acos(x.value), T(-1) / leg(x.value));
  }
  GAUSS_FUNCTION static S atan(const S& x) noexcept {
    return dual_detail::chained(x, Math<T>::atan(x.value), T(1) / (T(1) + x.value * x.value));
  }
  GAUSS_FUNCTION static S atan2(const S& y, const S& x) noexcept {
    const T square = x.value * x.value + y.value * y.value;
    const T by_y = x.value / square, by_x = -(y.value / square);
    S result;
    result.value = Math<T>::atan2(y.value, x.value);
    for (int i = 0; i < N; ++i) {
      result.tangent[i] = dual_detail::added(by_y, y.tangent[i]) + dual_detail::added(by_x, x.tangent[i]);
    }
    return result;
  }
  GAUSS_FUNCTION static S exp(const S& x) noexcept {
    const T value = Math<T>::exp(x.value);
    return dual_detail::chained(x, value, value);
  }
  GAUSS_FUNCTION static S log(const S& x) noexcept {
    return dual_detail::chained_where_it_moves(x, Math<T>::log(x.value), T(1) / x.value);
  }
  GAUSS_FUNCTION static S sinh(const S& x) noexcept {
    return dual_detail::chained(x, Math<T>::sinh(x.value), Math<T>::cosh(x.value));
  }
  GAUSS_FUNCTION static S cosh(const S& x) noexcept {
    return dual_detail::chained(x, Math<T>::cosh(x.value), Math<T>::sinh(x.value));
  }
  GAUSS_FUNCTION static S tanh(const S& x) noexcept {
    const T value = Math<T>::tanh(x.value);
    return dual_detail::chained(x, value, T(1) - value * value);
  }
  GAUSS_FUNCTION static S sqrt(const S& x) noexcept {
    const T value = Math<T>::sqrt(x.value);
    return dual_detail::chained_where_it_moves(x, value, T(1) / (T(2) * value));
  }
  GAUSS_FUNCTION static S pow(const S& x, const S& y) noexcept {
    const T value = Math<T>::pow(x.value, y.value);
    const T by_base = y.value * Math<T>::pow(x.value, y.value - T(1));
    const T by_exponent = value * Math<T>::log(x.value);
    S result;
    result.value = value;
    for (int i = 0; i < N; ++i) {
      result.tangent[i] = dual_detail::added(by_base, x.tangent[i]) + dual_detail::added(by_exponent, y.tangent[i]);
    }
    return result;
  }

  GAUSS_FUNCTION static Bool less(const S& a, const S& b) noexcept { return Math<T>::less(a.value, b.value); }
  GAUSS_FUNCTION static Bool at_most(const S& a, const S& b) noexcept { return Math<T>::at_most(a.value, b.value); }
  GAUSS_FUNCTION static S select(const Bool& condition, const S& a, const S& b) noexcept {
    S result;
    result.value = Math<T>::select(condition, a.value, b.value);
    for (int i = 0; i < N; ++i) result.tangent[i] = Math<T>::select(condition, a.tangent[i], b.tangent[i]);
    return result;
  }
  template <class... Rest>
  GAUSS_FUNCTION static Bool any(const Bool& first, const Rest&... rest) noexcept {
    return Math<T>::any(first, rest...);
  }
  /// Tangents are results, too.
  template <class... Rest>
  GAUSS_FUNCTION static Bool not_finite(const S& first, const Rest&... rest) noexcept {
#if defined(GAUSS_ALLOW_FAST_MATH)
    return Math<T>::any(has_lost(first), has_lost(rest)...);
#else
    GAUSS_IN_ORDER
    T sum = difference(first);
    ((sum = sum + difference(rest)), ...);
    return Math<T>::not_finite(sum);
#endif
  }
  GAUSS_FUNCTION static Status status(const Bool& singular_mass_matrix, const Bool& dependent_constraints,
                                      const Bool& not_finite, const Bool& violated_constraints = Bool(false)) noexcept {
    return Math<T>::status(singular_mass_matrix, dependent_constraints, not_finite, violated_constraints);
  }
  GAUSS_FUNCTION static Status worse(const Status& a, const Status& b) noexcept { return Math<T>::worse(a, b); }

  GAUSS_FUNCTION static S epsilon() noexcept { return S(Math<T>::epsilon()); }
  GAUSS_FUNCTION static S pi() noexcept { return S(Math<T>::pi()); }
  GAUSS_FUNCTION static S constant(double hi, double mid, double lo) noexcept {
    return S(Math<T>::constant(hi, mid, lo));
  }

 private:
  /// The cosine of the angle whose sine is x; by factors, so that it keeps its digits near 1.
  GAUSS_FUNCTION static T leg(const T& x) noexcept { return Math<T>::sqrt((T(1) - x) * (T(1) + x)); }
  /// 0 for finite numbers only, NaN for others.
  GAUSS_FUNCTION static T difference(const S& x) noexcept {
    GAUSS_IN_ORDER
    T sum = x.value - x.value;
    for (int i = 0; i < N; ++i) sum = sum + (x.tangent[i] - x.tangent[i]);
    return sum;
  }
  /// The same where compilers take such differences for 0.
  GAUSS_FUNCTION static Bool has_lost(const S& x) noexcept {
    Bool result = Math<T>::not_finite(x.value);
    for (int i = 0; i < N; ++i) result = Math<T>::any(result, Math<T>::not_finite(x.tangent[i]));
    return result;
  }
};

}  // namespace gauss
