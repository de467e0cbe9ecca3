#include "evaluate/decimal.hpp"

#include <cln/integer.h>
#include <cln/real.h>

#include <cmath>
#include <cstdint>

#include "support/assert.hpp"
#include "support/rational.hpp"

namespace gaussgen::evaluate {

namespace {

using support::Integer;
using support::Rational;

/// Exponents within which numbers are written without "e".
constexpr std::int64_t k_lowest_plain = -5;

Rational power_of_ten(std::int64_t exponent) {
  if (exponent == 0) return 1;
  const Rational size = cln::expt_pos(cln::cl_I(10), cln::cl_I(static_cast<long>(std::abs(exponent))));
  return exponent > 0 ? size : Rational(1 / size);
}

/// |value| ≈ mantissa * 10^(exponent + 1 - digits), the mantissa with exactly `digits` digits.
struct Decimal {
  Integer mantissa;
  std::int64_t exponent;
};

Decimal rounded(const Rational& size, std::int64_t guess, int digits) {
  const Rational limit = power_of_ten(digits);
  for (std::int64_t exponent = guess;; ++exponent) {
    const Integer mantissa = cln::round1(size * power_of_ten(digits - 1 - exponent));
    // Rounding up may give one digit more: 9.99 to 10.0.
    if (mantissa < limit) return {mantissa, exponent};
  }
}

}  // namespace

std::string to_decimal(const cln::cl_F& value, int digits) {
  GAUSS_ASSERT(digits > 0, "digits={}", digits);
  if (cln::zerop(value)) return "0";
  const Rational size = cln::abs(cln::rational(value));
  // 2^(e-1) <= |value| < 2^e, so this is the decimal exponent or one less.
  const double binary = static_cast<double>(cln::float_exponent(value)) - 1.0;
  auto guess = static_cast<std::int64_t>(std::floor(binary * 0.30102999566398119521));
  while (size < power_of_ten(guess)) --guess;
  while (size >= power_of_ten(guess + 1)) ++guess;
  const Decimal decimal = rounded(size, guess, digits);
  std::string text = support::to_text(decimal.mantissa);
  const std::string sign = cln::minusp(value) ? "-" : "";
  const std::int64_t exponent = decimal.exponent;
  if (exponent < k_lowest_plain || exponent >= digits) {
    if (digits > 1) text.insert(1, ".");
    return sign + text + "e" + (exponent < 0 ? "-" : "+") + std::to_string(std::abs(exponent));
  }
  if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + text;
  if (exponent + 1 < digits) text.insert(static_cast<std::size_t>(exponent + 1), ".");
  return sign + text;
}

double to_double(const cln::cl_F& value) { return support::to_double(value); }

}  // namespace gaussgen::evaluate
