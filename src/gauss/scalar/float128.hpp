#pragma once
// __float128 (GCC, libquadmath): link with -lquadmath. Include before or after emitted headers.
// SPDX-License-Identifier: MIT-0

#include <quadmath.h>

#include "gauss/math.hpp"

namespace gauss {

template <>
struct Math<__float128> : ScalarLogic<__float128> {
  using S = __float128;

  static S sin(S x) noexcept { return sinq(x); }
  static S cos(S x) noexcept { return cosq(x); }
  static S tan(S x) noexcept { return tanq(x); }
  static S asin(S x) noexcept { return asinq(x); }
  static S acos(S x) noexcept { return acosq(x); }
  static S atan(S x) noexcept { return atanq(x); }
  static S atan2(S y, S x) noexcept { return atan2q(y, x); }
  static S exp(S x) noexcept { return expq(x); }
  static S log(S x) noexcept { return logq(x); }
  static S sinh(S x) noexcept { return sinhq(x); }
  static S cosh(S x) noexcept { return coshq(x); }
  static S tanh(S x) noexcept { return tanhq(x); }
  static S sqrt(S x) noexcept { return sqrtq(x); }
  static S pow(S x, S y) noexcept { return powq(x, y); }
  static void sincos(S x, S& sine, S& cosine) noexcept { sincosq(x, &sine, &cosine); }

#if defined(GAUSS_ALLOW_FAST_MATH)
  // Functions of a library that was compiled without -ffast-math.
  template <class... Rest>
  static bool not_finite(S first, Rest... rest) noexcept {
    return (!finiteq(first) || ... || !finiteq(rest));
  }
#endif

  // -std=c++17 knows neither the suffix Q nor numeric_limits of this type, so: three doubles, and 2^-112.
  static S pi() noexcept { return constant(3.141592653589793, 1.2246467991473532e-16, -2.9947698097183397e-33); }
  static S epsilon() noexcept { return S(1.9259299443872359e-34); }
};

}  // namespace gauss
