#include "support/rational.hpp"

#include <cln/exception.h>
#include <cln/float.h>
#include <cln/integer_io.h>
#include <cln/rational_io.h>
#include <cln/real.h>

#include <climits>
#include <functional>
#include <limits>

#include "support/assert.hpp"

namespace gaussgen::support {

namespace {

std::string decimal(const Integer& value) {
  // print_integer takes the base explicitly: CLN's default printer flags are global and mutable.
  std::string digits;
  Integer rest = cln::abs(value);
  constexpr int k_chunk = 1'000'000'000;
  while (rest >= k_chunk) {
    const cln::cl_I_div_t split = cln::floor2(rest, k_chunk);
    const std::string part = std::to_string(cln::cl_I_to_int(split.remainder));
    digits.insert(0, std::string(9 - part.size(), '0') + part);
    rest = split.quotient;
  }
  digits.insert(0, std::to_string(cln::cl_I_to_int(rest)));
  return cln::minusp(value) ? "-" + digits : digits;
}

}  // namespace

bool is_integer(const Rational& value) { return cln::denominator(value) == 1; }

int to_int(const Rational& value) {
  GAUSS_ASSERT(is_integer(value) && cln::abs(value) <= INT_MAX, "value={}", to_text(value));
  return cln::cl_I_to_int(cln::numerator(value));
}

double to_double(const cln::cl_R& value) {
  // CLN throws where IEEE arithmetic would give infinity or zero.
  try {
    return cln::double_approx(value);
  } catch (const cln::floating_point_underflow_exception&) {
    return 0.0;
  } catch (const cln::floating_point_overflow_exception&) {
    constexpr double k_infinity = std::numeric_limits<double>::infinity();
    return cln::minusp(value) ? -k_infinity : k_infinity;
  }
}

std::string to_text(const Rational& value) {
  const std::string top = decimal(cln::numerator(value));
  return is_integer(value) ? top : top + "/" + decimal(cln::denominator(value));
}

std::size_t hash(const Rational& value) {
  constexpr std::size_t k_mix = 0x9E3779B97F4A7C15U;
  const Integer top = cln::numerator(value);
  if (is_integer(value) && cln::abs(top) < INT_MAX) return static_cast<std::size_t>(cln::cl_I_to_int(top)) * k_mix;
  // Linear in the digits, where writing them out would be quadratic.
  const Integer prime = cln::minus1(cln::ash(Integer(1), 61));
  const auto residue = [&](const Integer& part) { return cln::cl_I_to_ulong(cln::mod(part, prime)); };
  return (residue(top) * k_mix) ^ residue(cln::denominator(value));
}

}  // namespace gaussgen::support
