#pragma once
// Sine and cosine of a register of doubles, without a branch for angles of a mechanism.
// SPDX-License-Identifier: MIT-0
//
// xsimd 8 looks at all lanes together to choose how it takes multiples of π/2 off, so that the time and the last digit of one
// lane depend on the others. Here every lane up to 2^20 π/2 goes the same way: Cody and Waite's three parts of π/2 (1980), then
// Taylor's series, whose first terms left out are below 1e-18 for |r| ≤ π/4. Errors are below 2.5 units in the last
// place, near multiples of π/2 too.

#include <cstdint>
#include <utility>
#include <xsimd/xsimd.hpp>

namespace gauss::xsimd_detail {

/// c[0] + z (c[1] + z (…)).
template <class Batch, std::size_t N>
inline Batch polynomial(const Batch& z, const double (&c)[N]) noexcept {
  Batch value(c[N - 1]);
  for (std::size_t i = N - 1; i-- > 0;) value = xsimd::fma(value, z, Batch(c[i]));
  return value;
}

/// sin r and cos r for |r| <= π/4.
template <class Batch>
inline std::pair<Batch, Batch> sincos_near_zero(const Batch& r) noexcept {
  // ±1/n!, from 1/3! and from 1/4! on.
  constexpr double k_sine[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                               -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  constexpr double k_cosine[] = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
                                 1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
  const Batch z = r * r;
  const Batch sine = xsimd::fma(r * z, polynomial(z, k_sine), r);
  const Batch cosine = xsimd::fma(z * z, polynomial(z, k_cosine), xsimd::fnma(Batch(0.5), z, Batch(1.0)));
  return {sine, cosine};
}

/// Lanes beyond `k_limit`, of which angles of mechanisms have none, and infinities; kept out of line.
template <class Batch>
#if defined(__GNUC__)
__attribute__((noinline))
#endif
std::pair<Batch, Batch>
with_large_lanes(const Batch& x, const typename Batch::batch_bool_type& is_large, const Batch& sine,
                 const Batch& cosine) noexcept {
  const auto pair = xsimd::sincos(x);
  return {xsimd::select(is_large, pair.first, sine), xsimd::select(is_large, pair.second, cosine)};
}

template <class Arch>
inline std::pair<xsimd::batch<double, Arch>, xsimd::batch<double, Arch>> sincos(
    const xsimd::batch<double, Arch>& x) noexcept {
  using Batch = xsimd::batch<double, Arch>;
  using Bits = xsimd::batch<std::int64_t, Arch>;
  // π/2 in parts of 33 bits, so that their products with numbers of up to 20 bits are exact.
  constexpr double k_first = 0x1.921fb544p+0, k_second = 0x1.0b4611a6p-34, k_third = 0x1.3198a2e037073p-69;
  constexpr double k_limit = 0x1p20 * 1.5707963;
  // The sum's last bits are those of the nearest whole number.
  constexpr double k_shift = 0x1.8p52;
  const Batch shifted = xsimd::fma(x, Batch(0.63661977236758134308), Batch(k_shift));
  const Batch n = shifted - Batch(k_shift);
  Batch r = xsimd::fnma(n, Batch(k_first), x);
  r = xsimd::fnma(n, Batch(k_second), r);
  r = xsimd::fnma(n, Batch(k_third), r);
  const auto [s, c] = sincos_near_zero(r);

  // Quadrants 1 and 3 swap the two; sine is negative in 2 and 3, cosine in 1 and 2.
  const Bits quadrant = xsimd::bitwise_cast<Bits>(shifted);
  const auto is_odd = (xsimd::bitwise_cast<Batch>(quadrant << 63) ^ Batch(1.0)) < Batch(0.0);  // -1 < 0
  const Batch sign_of_sine = xsimd::bitwise_cast<Batch>((quadrant & Bits(2)) << 62);
  const Batch sign_of_cosine = xsimd::bitwise_cast<Batch>(((quadrant + Bits(1)) & Bits(2)) << 62);
  const Batch sine = xsimd::select(is_odd, c, s) ^ sign_of_sine;
  const Batch cosine = xsimd::select(is_odd, s, c) ^ sign_of_cosine;
  const auto is_large = xsimd::abs(x) > Batch(k_limit);
  if (xsimd::any(is_large)) return with_large_lanes(x, is_large, sine, cosine);
  return {sine, cosine};
}

}  // namespace gauss::xsimd_detail
