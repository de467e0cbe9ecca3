#pragma once
// xsimd::batch: one state per lane. Conditions are masks, so lanes never disturb each other.
// SPDX-License-Identifier: MIT-0

#include <type_traits>
#include <xsimd/xsimd.hpp>

#include "gauss/math.hpp"
#include "gauss/scalar/xsimd_sincos.hpp"

namespace gauss {

/// The conditions of all lanes.
template <class Mask>
struct BatchStatus {
  Mask singular_mass_matrix = Mask(false);
  Mask dependent_constraints = Mask(false);
  Mask not_finite = Mask(false);
  Mask violated_constraints = Mask(false);

  /// Lanes whose results are not to be trusted.
  Mask bad() const noexcept {
    return singular_mass_matrix || dependent_constraints || not_finite || violated_constraints;
  }
  bool any() const noexcept { return xsimd::any(bad()); }

  /// In lanes of `mask`; ok in others.
  BatchStatus within(const Mask& mask) const noexcept {
    return {singular_mass_matrix && mask, dependent_constraints && mask, not_finite && mask,
            violated_constraints && mask};
  }

  /// Of one lane, as a scalar computation would have it.
  Status lane(std::size_t i) const noexcept {
    return ScalarLogic<double>::status(singular_mass_matrix.get(i), dependent_constraints.get(i), not_finite.get(i),
                                       violated_constraints.get(i));
  }
};

template <class T, class Arch>
struct Math<xsimd::batch<T, Arch>> {
  using S = xsimd::batch<T, Arch>;
  using Bool = typename S::batch_bool_type;
  using Status = BatchStatus<Bool>;

  static S sin(const S& x) noexcept { return pair(x).first; }
  static S cos(const S& x) noexcept { return pair(x).second; }
  /// xsimd's own looks at all lanes together.
  static S tan(const S& x) noexcept {
    const auto both = pair(x);
    return both.first / both.second;
  }
  static S asin(const S& x) noexcept { return xsimd::asin(x); }
  static S acos(const S& x) noexcept { return xsimd::acos(x); }
  static S atan(const S& x) noexcept { return xsimd::atan(x); }
  static S atan2(const S& y, const S& x) noexcept { return xsimd::atan2(y, x); }
  static S exp(const S& x) noexcept { return xsimd::exp(x); }
  static S log(const S& x) noexcept { return xsimd::log(x); }
  static S sinh(const S& x) noexcept { return xsimd::sinh(x); }
  static S cosh(const S& x) noexcept { return xsimd::cosh(x); }
  static S tanh(const S& x) noexcept { return xsimd::tanh(x); }
  static S sqrt(const S& x) noexcept { return xsimd::sqrt(x); }
  static S pow(const S& x, const S& y) noexcept { return xsimd::pow(x, y); }
  static void sincos(const S& x, S& sine, S& cosine) noexcept {
    const auto both = pair(x);
    sine = both.first;
    cosine = both.second;
  }

  static Bool less(const S& a, const S& b) noexcept { return a < b; }
  static Bool at_most(const S& a, const S& b) noexcept { return a <= b; }
  static S select(const Bool& condition, const S& a, const S& b) noexcept { return xsimd::select(condition, a, b); }
  template <class... Rest>
  static Bool any(const Bool& first, const Rest&... rest) noexcept {
    return (first || ... || rest);
  }
  template <class... Rest>
  static Bool not_finite(const S& first, const Rest&... rest) noexcept {
#if defined(GAUSS_ALLOW_FAST_MATH)
    // Lane by lane: how bits of a batch are had depends on the version of xsimd.
    T is_bad[S::size] = {};
    mark(is_bad, first);
    (mark(is_bad, rest), ...);
    return S::load_unaligned(is_bad) > S(0);
#else
    GAUSS_IN_ORDER
    S sum = first - first;
    ((sum = sum + (rest - rest)), ...);
    return xsimd::isnan(sum);
#endif
  }
  static Status status(const Bool& singular_mass_matrix, const Bool& dependent_constraints, const Bool& not_finite,
                       const Bool& violated_constraints = Bool(false)) noexcept {
    return {singular_mass_matrix, dependent_constraints, not_finite, violated_constraints};
  }
  static Status worse(const Status& a, const Status& b) noexcept {
    return {a.singular_mass_matrix || b.singular_mass_matrix, a.dependent_constraints || b.dependent_constraints,
            a.not_finite || b.not_finite, a.violated_constraints || b.violated_constraints};
  }

  static S epsilon() noexcept { return S(std::numeric_limits<T>::epsilon()); }
  static S pi() noexcept { return S(Math<T>::pi()); }
  static S constant(double hi, double mid, double lo) noexcept { return S(Math<T>::constant(hi, mid, lo)); }

 private:
  static void mark(T (&is_bad)[S::size], const S& x) noexcept {
    T lanes[S::size];
    x.store_unaligned(lanes);
    for (std::size_t i = 0; i < S::size; ++i) {
      if (detail::has_largest_exponent(lanes[i])) is_bad[i] = T(1);
    }
  }

  static std::pair<S, S> pair(const S& x) noexcept {
    if constexpr (std::is_same_v<T, double>) {
      return xsimd_detail::sincos(x);
    } else {
      return xsimd::sincos(x);
    }
  }
};

}  // namespace gauss
