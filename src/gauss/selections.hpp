// Arithmetic without branches, so that lanes of a batch may differ.
// SPDX-License-Identifier: MIT-0
#ifndef GAUSS_SELECTIONS_HPP
#define GAUSS_SELECTIONS_HPP

#include "gauss/math.hpp"

namespace gauss {

namespace detail {

/// Numbers 0 and 1 stand for conditions here: they combine by products for every type.
template <class S>
GAUSS_FUNCTION S indicator(const typename Math<S>::Bool& condition) {
  return Math<S>::select(condition, S(1), S(0));
}

template <class S>
GAUSS_FUNCTION S positive(const S& x) {
  return indicator<S>(Math<S>::less(S(0), x));
}

template <class S>
GAUSS_FUNCTION S absolute(const S& x) {
  return Math<S>::select(Math<S>::less(x, S(0)), -x, x);
}

template <class S>
GAUSS_FUNCTION S larger(const S& a, const S& b) {
  return Math<S>::select(Math<S>::less(a, b), b, a);
}

/// 1/x, and 0 where `use` is 0: nothing is divided by 0, not even in a lane that is not looked at.
template <class S>
GAUSS_FUNCTION S reciprocal(const S& x, const S& use) {
  const auto is_used = Math<S>::less(S(0), use);
  return Math<S>::select(is_used, S(1) / Math<S>::select(is_used, x, S(1)), S(0));
}

/// sqrt whose derivative at 0 is 0.
template <class S>
GAUSS_FUNCTION S root(const S& x) {
  const auto is_positive = Math<S>::less(S(0), x);
  return Math<S>::select(is_positive, Math<S>::sqrt(Math<S>::select(is_positive, x, S(1))), S(0));
}

template <class S>
GAUSS_FUNCTION void swap_where(const typename Math<S>::Bool& condition, S& a, S& b) {
  const S before = a;
  a = Math<S>::select(condition, b, a);
  b = Math<S>::select(condition, before, b);
}

/// A number that compilers know.
template <int value>
struct Known {
  GAUSS_FUNCTION constexpr operator int() const { return value; }
};

/// Of a number that compilers know, one that they see to be exact.
template <class S, int value>
GAUSS_FUNCTION S number(Known<value>) {
  return S(value);
}

template <class S>
GAUSS_FUNCTION S number(int value) {
  return S(value);
}

/// Of the first n; arrays may be longer.
template <class S, int N, class Count = Known<N>>
GAUSS_FUNCTION S inner(const S (&a)[N], const S (&b)[N], Count n = {}) {
  S sum = a[0] * b[0];
  for (int i = 1; i < n; ++i) sum = sum + a[i] * b[i];
  return sum;
}

}  // namespace detail

}  // namespace gauss

#endif  // GAUSS_SELECTIONS_HPP
