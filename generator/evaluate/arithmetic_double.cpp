#include "evaluate/arithmetic_double.hpp"

#include <cln/float.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "support/assert.hpp"

namespace gaussgen::evaluate {

namespace {

constexpr long double k_pi = 3.14159265358979323846264338327950288L;

template <class F>
Outcome<F> finite(F value) {
  if (!std::isfinite(value)) return Outcome<F>::undefined(reason::k_overflow);
  return value;
}

// 32 bits at a time, since cl_I has no constructor from every 64-bit type on every platform.
template <class F>
Rational exact_value(F value) {
  GAUSS_ASSERT(std::isfinite(value), "value={}", static_cast<double>(value));
  int exponent = 0;
  F rest = std::frexp(std::fabs(value), &exponent);
  cln::cl_I digits = 0;
  for (; rest != 0; exponent -= 32) {
    rest = std::ldexp(rest, 32);
    const auto part = static_cast<std::uint32_t>(rest);
    rest -= static_cast<F>(part);
    digits = cln::ash(digits, 32) + cln::cl_I(static_cast<unsigned int>(part));
  }
  const Rational size =
      exponent >= 0 ? Rational(cln::ash(digits, exponent)) : digits / cln::ash(cln::cl_I(1), -exponent);
  return value < 0 ? Rational(-size) : size;
}

// CLN converts to double only, and takes subnormal numbers for zero: so the value is brought near one, rounded in two
// pieces of 53 bits, and taken back.
template <class F>
F rounded(const Rational& value) {
  const cln::cl_I above = cln::numerator(value), below = cln::denominator(value);
  const auto digits_above = static_cast<std::int64_t>(cln::integer_length(above));
  const auto digits_below = static_cast<std::int64_t>(cln::integer_length(below));
  constexpr std::int64_t k_exact = std::numeric_limits<double>::digits;
  // Both are numbers of the type, and a division is rounded correctly.
  if (digits_above <= k_exact && digits_below <= k_exact)
    return static_cast<F>(cln::cl_I_to_long(above)) / static_cast<F>(cln::cl_I_to_long(below));
  const std::int64_t exponent = digits_above - digits_below;
  constexpr std::int64_t k_beyond_any = 100'000;
  if (exponent > k_beyond_any)
    return value < 0 ? -std::numeric_limits<F>::infinity() : std::numeric_limits<F>::infinity();
  if (exponent < -k_beyond_any) return 0;
  const cln::cl_I shift = cln::ash(cln::cl_I(1), static_cast<int>(std::abs(exponent)));
  const Rational near_one = exponent > 0 ? Rational(value / shift) : value * shift;
  const double high = cln::double_approx(near_one);
  const double low = cln::double_approx(near_one - exact(high));
  return std::ldexp(static_cast<F>(high) + static_cast<F>(low), static_cast<int>(exponent));
}

template <class F>
F applied(ir::Function function, const std::vector<F>& x) {
  using ir::Function;
  switch (function) {
    case Function::sin: return std::sin(x[0]);
    case Function::cos: return std::cos(x[0]);
    case Function::tan: return std::tan(x[0]);
    case Function::asin: return std::asin(x[0]);
    case Function::acos: return std::acos(x[0]);
    case Function::atan: return std::atan(x[0]);
    case Function::atan2: return std::atan2(x[0], x[1]);
    case Function::exp: return std::exp(x[0]);
    case Function::log: return std::log(x[0]);
    case Function::sinh: return std::sinh(x[0]);
    case Function::cosh: return std::cosh(x[0]);
    case Function::tanh: return std::tanh(x[0]);
    default: GAUSS_ASSERT(false, "function={}", ir::name_of(function)); return 0;
  }
}

}  // namespace

Rational exact(double value) { return exact_value(value); }
Rational exact(long double value) { return exact_value(value); }

template <class F>
F NativeArithmetic<F>::number(const Rational& value) const {
  return rounded<F>(value);
}

template <class F>
F NativeArithmetic<F>::pi() const {
  return static_cast<F>(k_pi);
}

template <class F>
F NativeArithmetic<F>::epsilon() const {
  return std::numeric_limits<F>::epsilon() / 2;
}

template <class F>
Outcome<F> NativeArithmetic<F>::sum(const Rational& constant, const ir::Coefficients& coefficients,
                                    const std::vector<F>& x) const {
  F total = number(constant);
  for (std::size_t i = 0; i < x.size(); ++i) total += number(coefficients[i]) * x[i];
  return finite(total);
}

template <class F>
Outcome<F> NativeArithmetic<F>::product(const std::vector<F>& x) const {
  F total = 1;
  for (const F factor : x) total *= factor;
  return finite(total);
}

template <class F>
Outcome<F> NativeArithmetic<F>::power(F x, const Rational& exponent) const {
  if (const char* trouble = trouble_of_power<F>(x, exponent, 0)) return Outcome<F>::undefined(trouble);
  const cln::cl_I root = cln::denominator(exponent);
  if (root > 2 || !is_small(exponent)) return finite(std::pow(x, number(exponent)));
  const F base = root == 2 ? std::sqrt(x) : x;
  const int times = cln::cl_I_to_int(cln::abs(cln::numerator(exponent)));
  const F result = repeated_product(base, times);
  return finite(exponent < 0 ? 1 / result : result);
}

template <class F>
Outcome<F> NativeArithmetic<F>::call(ir::Function function, const std::vector<F>& x) const {
  if (const char* trouble = trouble_of_call<F>(function, x, 0, 1)) return Outcome<F>::undefined(trouble);
  return finite(applied(function, x));
}

template class NativeArithmetic<double>;
template class NativeArithmetic<long double>;

}  // namespace gaussgen::evaluate
