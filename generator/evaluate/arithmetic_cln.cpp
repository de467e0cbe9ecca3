#include "evaluate/arithmetic_cln.hpp"

#include <cln/real.h>

#include <algorithm>

#include "evaluate/arithmetic_double.hpp"
#include "support/assert.hpp"

namespace gaussgen::evaluate {

namespace {

using cln::cl_F;
using Result = Outcome<cl_F>;

constexpr int k_guard_digits = 10;
constexpr int k_guard_bits = 64;

/// Below this CLN would take machine floats, which have other rules.
constexpr int k_fewest_digits = 30;

/// Binary exponents beyond this count as overflow, or as zero: four times what 128-bit floats reach is never passed by
/// a sound model, and CLN would rather exhaust memory than stop.
constexpr int k_exponent_bits = 16;
constexpr std::int64_t k_exponent_limit = 1 << k_exponent_bits;

std::int64_t exponent_of(const cl_F& x) {
  return cln::zerop(x) ? 0 : static_cast<std::int64_t>(cln::float_exponent(x));
}

std::int64_t bits_above_one(const cl_F& x) { return std::max<std::int64_t>(0, exponent_of(x)); }

/// CLN reports trouble by exceptions; none leaves this file.
template <class Operation>
Result guarded(Operation operation) {
  try {
    return operation();
  } catch (const cln::floating_point_exception&) {
    return Result::undefined(reason::k_overflow);
  } catch (const cln::division_by_0_exception&) {
    return Result::undefined(reason::k_division);
  }
}

}  // namespace

Arithmetic<cl_F>::Arithmetic(int digits)
    : digits_(digits),
      format_(cln::float_format(static_cast<uintE>(std::max(digits + k_guard_digits, k_fewest_digits)))) {
  GAUSS_ASSERT(digits > 0, "digits={}", digits);
}

cl_F Arithmetic<cl_F>::number(double value) const { return number(exact(value)); }

cl_F Arithmetic<cl_F>::epsilon() const {
  const cl_F one = cln::cl_float(1, format_);
  return cln::scale_float(one, -static_cast<sintC>(cln::float_digits(one)));
}

Result Arithmetic<cl_F>::checked(const cl_F& value) const {
  const std::int64_t exponent = exponent_of(value);
  if (exponent > k_exponent_limit) return Result::undefined(reason::k_overflow);
  if (exponent < -k_exponent_limit) return cln::cl_float(0, format_);
  return number(value);
}

cl_F Arithmetic<cl_F>::widened(const cl_F& x, std::int64_t bits) const {
  const std::int64_t own = static_cast<std::int64_t>(cln::float_digits(cln::cl_float(1, format_)));
  return cln::cl_float(x, static_cast<cln::float_format_t>(own + bits));
}

Result Arithmetic<cl_F>::sum(const Rational& constant, const ir::Coefficients& coefficients,
                             const std::vector<cl_F>& x) const {
  return guarded([&] {
    cl_F total = number(constant);
    for (std::size_t i = 0; i < x.size(); ++i) total = total + number(coefficients[i]) * x[i];
    return checked(total);
  });
}

Result Arithmetic<cl_F>::product(const std::vector<cl_F>& x) const {
  return guarded([&]() -> Result {
    cl_F total = cln::cl_float(1, format_);
    for (const cl_F& factor : x) {
      const Result next = checked(total * factor);
      if (!next) return next;
      total = *next;
    }
    return total;
  });
}

Result Arithmetic<cl_F>::power(const cl_F& x, const Rational& exponent) const {
  const cl_F zero = cln::cl_float(0, format_);
  if (const char* trouble = trouble_of_power(x, exponent, zero)) return Result::undefined(trouble);
  if (cln::zerop(x)) return zero;
  if (!is_small(exponent)) return Result::undefined(reason::k_exponent);
  const std::int64_t times = cln::cl_I_to_int(cln::numerator(exponent));
  const std::int64_t root = cln::cl_I_to_int(cln::denominator(exponent));
  const std::int64_t size = exponent_of(x) * times / root;
  if (size > 2 * k_exponent_limit) return Result::undefined(reason::k_overflow);
  if (size < -2 * k_exponent_limit) return zero;
  return guarded([&] {
    const cl_F wide = widened(x, k_guard_bits);
    if (root > 2) return checked(cln::exp(cln::ln(wide) * cln::cl_float(exponent, wide)));
    const cl_F size_of = repeated_product(root == 2 ? cln::sqrt(wide) : wide, static_cast<int>(std::abs(times)));
    return checked(times < 0 ? cln::recip(size_of) : size_of);
  });
}

Result Arithmetic<cl_F>::call(ir::Function function, const std::vector<cl_F>& x) const {
  const char* trouble = trouble_of_call(function, x, cln::cl_float(0, format_), cln::cl_float(1, format_));
  if (trouble != nullptr) return Result::undefined(trouble);
  return guarded([&] { return applied(function, x); });
}

Result Arithmetic<cl_F>::applied(ir::Function function, const std::vector<cl_F>& x) const {
  using ir::Function;
  const auto angle = [this](const cl_F& y, const cl_F& z) { return checked(cln::cl_float(cln::atan(z, y), format_)); };
  // sqrt(1 - x²), exact where x is near ±1
  const auto complement = [this](const cl_F& sine) {
    const cl_F one = cln::cl_float(1, format_);
    return cln::sqrt((one - sine) * (one + sine));
  };
  switch (function) {
    case Function::sin:
    case Function::cos:
    case Function::tan: return trigonometric(function, x[0]);
    case Function::exp:
    case Function::sinh:
    case Function::cosh:
    case Function::tanh: return exponential(function, x[0]);
    case Function::log: return checked(cln::ln(x[0]));
    case Function::asin: return angle(x[0], complement(x[0]));
    case Function::acos: return angle(complement(x[0]), x[0]);
    case Function::atan: return angle(x[0], cln::cl_float(1, format_));
    case Function::atan2: return angle(x[0], x[1]);
    default: GAUSS_ASSERT(false, "function={}", ir::name_of(function)); return x[0];
  }
}

// The reduction by pi loses the bits of x above one, and as many again where the result is near zero.
Result Arithmetic<cl_F>::trigonometric(ir::Function function, const cl_F& x) const {
  const std::int64_t own = static_cast<std::int64_t>(cln::float_digits(x));
  const std::int64_t extra = exponent_of(x) > 0 && !cln::zerop(x) ? bits_above_one(x) + own : 0;
  const cl_F wide = widened(x, extra + k_guard_bits);
  if (function == ir::Function::sin) return checked(cln::sin(wide));
  if (function == ir::Function::cos) return checked(cln::cos(wide));
  const cl_F bottom = cln::cos(wide);
  if (cln::zerop(bottom)) return Result::undefined(reason::k_pole);
  return checked(cln::sin(wide) / bottom);
}

Result Arithmetic<cl_F>::exponential(ir::Function function, const cl_F& x) const {
  using ir::Function;
  const bool is_far = exponent_of(x) > k_exponent_bits;
  if (function == Function::tanh) {
    const bool is_flat = is_far || cln::abs(x) > cln::cl_float(static_cast<int>(cln::float_digits(x)), x);
    if (is_flat) return cln::cl_float(cln::minusp(x) ? -1 : 1, format_);
  } else if (is_far) {
    if (function == Function::exp && cln::minusp(x)) return cln::cl_float(0, format_);
    return Result::undefined(reason::k_overflow);
  }
  const cl_F wide = widened(x, bits_above_one(x) + k_guard_bits);
  switch (function) {
    case Function::exp: return checked(cln::exp(wide));
    case Function::sinh: return checked(cln::sinh(wide));
    case Function::cosh: return checked(cln::cosh(wide));
    default: return checked(cln::tanh(wide));
  }
}

}  // namespace gaussgen::evaluate
