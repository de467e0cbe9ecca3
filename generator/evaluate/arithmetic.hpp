#pragma once
// What the interpreter asks of a number type, and what all of them share.

#include <vector>

#include "evaluate/outcome.hpp"
#include "ir/node.hpp"

namespace gaussgen::evaluate {

using support::Rational;

/// The number type T as the interpreter sees it. Specialised in arithmetic_*.hpp with
///
///   T number(const Rational&)                              a constant
///   T pi(), T epsilon()                                    epsilon: rounding unit of the type
///   Outcome<T> sum(constant, coefficients, x)              constant + Σ coefficients[i] x[i], from left to right
///   Outcome<T> product(x)                                  Π x[i], from left to right
///   Outcome<T> power(x, exponent)
///   Outcome<T> call(function, x)                           sin to tanh of ir::Function
///   bool less(a, b), bool is_true(x)                       true is any number but zero
///
/// A result that is not a finite real number is undefined, for every type: no exception, no infinity, no NaN.
template <class T>
class Arithmetic;

namespace reason {
inline constexpr const char* k_overflow = "the number is too large";
inline constexpr const char* k_division = "division by zero";
inline constexpr const char* k_root = "fractional power of a negative number";
inline constexpr const char* k_exponent = "the exponent is too large";
inline constexpr const char* k_logarithm = "logarithm of a number that is not positive";
inline constexpr const char* k_arc = "inverse sine or cosine of a number outside [-1, 1]";
inline constexpr const char* k_direction = "direction of a vector of length zero";
inline constexpr const char* k_pole = "pole of the tangent";
inline constexpr const char* k_rounding = "rounding leaves no digit of the number";
inline constexpr const char* k_no_bound = "the value has no first-order error bound here";
inline constexpr const char* k_unbound = "the symbol has no value";
}  // namespace reason

/// Whole exponents up to this size are computed by repeated multiplication.
inline constexpr int k_largest_exponent = 1 << 20;

inline bool is_small(const Rational& exponent) {
  return cln::abs(cln::numerator(exponent)) <= k_largest_exponent && cln::denominator(exponent) <= k_largest_exponent;
}

/// x^n for n > 0
template <class T>
T repeated_product(T x, int n) {
  for (; n % 2 == 0; n /= 2) x = x * x;
  T result = x;
  for (n /= 2; n > 0; n /= 2) {
    x = x * x;
    if (n % 2 != 0) result = result * x;
  }
  return result;
}

/// Why base^exponent is not a real number, or null.
template <class T>
const char* trouble_of_power(const T& base, const Rational& exponent, const T& zero) {
  if (base == zero && exponent < 0) return reason::k_division;
  if (base < zero && !support::is_integer(exponent)) return reason::k_root;
  return nullptr;
}

/// Why function(x) is not a real number, or null.
template <class T>
const char* trouble_of_call(ir::Function function, const std::vector<T>& x, const T& zero, const T& one) {
  switch (function) {
    case ir::Function::log: return x[0] > zero ? nullptr : reason::k_logarithm;
    case ir::Function::asin:
    case ir::Function::acos: return x[0] > one || x[0] < -one ? reason::k_arc : nullptr;
    case ir::Function::atan2: return x[0] == zero && x[1] == zero ? reason::k_direction : nullptr;
    default: return nullptr;
  }
}

}  // namespace gaussgen::evaluate
