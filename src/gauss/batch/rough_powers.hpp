// Logarithms and powers of 2 of lanes, to five digits: for lengths of steps, which need no more.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_BATCH_ROUGH_POWERS_HPP
#define GAUSS_BATCH_ROUGH_POWERS_HPP

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "gauss/scalar/xsimd.hpp"

namespace gauss::batch {

namespace detail {

/// How numbers are stored (IEEE 754).
template <class Number>
struct Stored {
  static_assert(std::numeric_limits<Number>::is_iec559);
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  static constexpr int digits = std::numeric_limits<Number>::digits - 1;
  static constexpr int bias = std::numeric_limits<Number>::max_exponent - 1;
  static constexpr Bits one = static_cast<Bits>(bias) << digits;
  static constexpr Bits fraction = (Bits(1) << digits) - 1;
  static constexpr Number whole = static_cast<Number>(Bits(1) << digits);  ///< from here on, numbers are whole
};

/// The same bytes: how xsimd calls that depends on its version.
template <class To, class From>
To same_bytes(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(To));
  return to;
}

}  // namespace detail

/// log2(x) to 2e-5, of positive numbers that are not subnormal. Nothing else than a number has one.
template <class Batch>
Batch rough_log2(const Batch& x) {
  using Number = typename Batch::value_type;
  using Stored = detail::Stored<Number>;
  using Bits = xsimd::batch<typename Stored::Bits, typename Batch::arch_type>;
  const Bits bits = detail::same_bytes<Bits>(x);
  // The exponent, as the last digits of a whole number.
  const Bits exponent = (bits >> Stored::digits) | detail::same_bytes<Bits>(Batch(Stored::whole));
  const Batch whole = detail::same_bytes<Batch>(exponent) - Batch(Stored::whole + Number(Stored::bias));
  const Batch m = detail::same_bytes<Batch>((bits & Bits(Stored::fraction)) | Bits(Stored::one));
  // Of the least error on [1, 2] (mpmath.chebyfit).
  Batch sum(Number(0.0430049577919));
  for (const double next : {-0.402513393549, 1.58947429498, -3.48987855068, 5.04785541344, -2.7879262073})
    sum = sum * m + Batch(Number(next));
  return whole + sum + Number(0) * x;
}

/// 2^y to 3e-6, and at least 2^-1000, or 2^-120 of `float`; y is below 1000, or 120.
template <class Batch>
Batch rough_exp2(const Batch& y) {
  using Number = typename Batch::value_type;
  using Stored = detail::Stored<Number>;
  using Bits = xsimd::batch<typename Stored::Bits, typename Batch::arch_type>;
  // What is no number stays one: the second of two is taken then.
  const Batch bounded = xsimd::max(Batch(sizeof(Number) == 8 ? Number(-1000) : Number(-120)), y);
  const Batch shift(Number(1.5) * Stored::whole);
  const Batch shifted = bounded + shift;
  const Batch part = bounded - (shifted - shift);
  const Bits scale = (detail::same_bytes<Bits>(shifted) << Stored::digits) + Bits(Stored::one);
  // Of the least error on [-1/2, 1/2] (mpmath.chebyfit).
  Batch sum(Number(0.00966636851539));
  for (const double next : {0.0559219758423, 0.24022349038, 0.693121045203, 1.0}) sum = sum * part + Batch(Number(next));
  return sum * detail::same_bytes<Batch>(scale);
}

}  // namespace gauss::batch

#endif  // GAUSS_BATCH_ROUGH_POWERS_HPP
