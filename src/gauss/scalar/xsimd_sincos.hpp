#pragma once
// Sine and cosine of a register of doubles, without a branch for angles of a mechanism.
// SPDX-License-Identifier: MIT-0
//
// xsimd 8 looks at all lanes together to choose how it takes multiples of π/2 off, so that the time and the last digit of one
// lane depend on the others. Here every lane up to 2^20 π/2 goes the same way: Cody and Waite's three parts of π/2 (1980), then
// polynomials on |r| ≤ π/4. Errors are below 2.5 units in the last place, near multiples of π/2 too.

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
  // By tools/sincos_coefficients.py: errors of 2e-17 and 9e-19.
  constexpr double k_sine[] = {-0.16666666666666666,  0.008333333333330948,    -0.00019841269836758574,
                               2.755731610255244e-06, -2.5051131845003624e-08, 1.5918129294866608e-10};
  constexpr double k_cosine[] = {0.041666666666666664,    -0.0013888888888887398, 2.480158729876569e-05,
                                 -2.7557317271729793e-07, 2.08761462684032e-09,   -1.1382632425521717e-11};
  const Batch z = r * r;
  const Batch sine = xsimd::fma(r * z, polynomial(z, k_sine), r);
  const Batch cosine = xsimd::fma(z * z, polynomial(z, k_cosine), xsimd::fnma(Batch(0.5), z, Batch(1.0)));
  return {sine, cosine};
}

// Lanes beyond `k_limit`, of which angles of mechanisms have none, and infinities; kept out of line. What they are given goes by value and
// comes back in a register: an address would keep it, and the state that it came from, in memory on the usual way, too.
#if defined(__GNUC__)
#define GAUSS_RARE __attribute__((noinline, cold))
#else
#define GAUSS_RARE
#endif

template <class Batch>
GAUSS_RARE Batch sine_of_large(Batch x, typename Batch::batch_bool_type is_large, Batch sine) noexcept {
  return xsimd::select(is_large, xsimd::sincos(x).first, sine);
}

template <class Batch>
GAUSS_RARE Batch cosine_of_large(Batch x, typename Batch::batch_bool_type is_large, Batch cosine) noexcept {
  return xsimd::select(is_large, xsimd::sincos(x).second, cosine);
}

#undef GAUSS_RARE

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

  // Quadrants 1 and 3 swap the two; sine is negative in 2 and 3, cosine in 1 and 2: signs are the last two bits of n.
  const Bits bits = xsimd::bitwise_cast<Bits>(shifted);
  const Batch last = xsimd::bitwise_cast<Batch>(bits << 63);
  const Batch sign_of_sine = xsimd::bitwise_cast<Batch>(bits << 62) & Batch(-0.0);
  const Batch sign_of_cosine = sign_of_sine ^ last;
  const auto is_odd = (last ^ Batch(1.0)) < Batch(0.0);
  Batch sine = xsimd::select(is_odd, c, s) ^ sign_of_sine;
  Batch cosine = xsimd::select(is_odd, s, c) ^ sign_of_cosine;
  const auto is_large = xsimd::abs(x) > Batch(k_limit);
  if (xsimd::any(is_large)) {
    sine = sine_of_large<Batch>(x, is_large, sine);
    cosine = cosine_of_large<Batch>(x, is_large, cosine);
  }
  return {sine, cosine};
}

}  // namespace gauss::xsimd_detail
