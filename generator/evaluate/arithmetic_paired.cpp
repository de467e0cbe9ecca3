#include "evaluate/arithmetic_paired.hpp"

#include <algorithm>

namespace gaussgen::evaluate {

namespace {

using cln::cl_F;
using Result = Outcome<Paired>;

/// Rounding is smaller than what it is the rounding of by many digits; this is where it has none left.
constexpr int k_digits_of_rounding = 6;

std::vector<cl_F> fine_of(const std::vector<Paired>& x) {
  std::vector<cl_F> values;
  for (const Paired& entry : x) values.push_back(entry.fine);
  return values;
}

std::vector<cl_F> coarse_of(const std::vector<Paired>& x) {
  std::vector<cl_F> values;
  for (const Paired& entry : x) values.push_back(entry.coarse);
  return values;
}

cl_F largest(const cl_F& a, const cl_F& b) { return a < b ? b : a; }

}  // namespace

Arithmetic<Paired>::Arithmetic(int digits, int more) : fine_(digits + more), coarse_(digits) {}

/// `size`: of what the number was made of.
Result Arithmetic<Paired>::settled(const Numbers& fine, const Numbers& coarse, const cl_F& size) const {
  if (!fine) return Result::undefined(fine.reason());
  if (!coarse) return Result::undefined(coarse.reason());
  const Paired value{*fine, *coarse};
  if (is_known(value) || apart(value) > rounding() * size) return value;
  return number(Rational(0));
}

bool Arithmetic<Paired>::is_known(const Paired& x) const {
  const cl_F distance = apart(x);
  return distance + distance <= cln::abs(x.fine);
}

cl_F Arithmetic<Paired>::apart(const Paired& x) const { return cln::abs(x.fine - fine_.number(x.coarse)); }

/// Of 1, where it has no digits left.
cl_F Arithmetic<Paired>::rounding() const { return fine_.number(cln::expt(Rational(10), -k_digits_of_rounding)); }

Result Arithmetic<Paired>::sum(const Rational& constant, const ir::Coefficients& coefficients,
                               const std::vector<Paired>& x) const {
  cl_F size = cln::abs(fine_.number(constant));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const cl_F term = fine_.number(coefficients[i]) * x[i].fine;
    size = largest(size, cln::abs(term));
  }
  return settled(fine_.sum(constant, coefficients, fine_of(x)), coarse_.sum(constant, coefficients, coarse_of(x)),
                 size);
}

Result Arithmetic<Paired>::product(const std::vector<Paired>& x) const {
  const Numbers fine = fine_.product(fine_of(x));
  return settled(fine, coarse_.product(coarse_of(x)), fine ? cln::abs(*fine) : integer(0));
}

Result Arithmetic<Paired>::power(const Paired& x, const Rational& exponent) const {
  const bool has_bound = support::is_integer(exponent) && cln::plusp(exponent);
  if (!has_bound && !is_known(x)) return Result::undefined(reason::k_rounding);
  const Numbers fine = fine_.power(x.fine, exponent);
  return settled(fine, coarse_.power(x.coarse, exponent), fine ? cln::abs(*fine) : integer(0));
}

/// 1 and -1 for what is beyond by rounding.
Paired Arithmetic<Paired>::within_arc(const Paired& x) const {
  const int sign = cln::minusp(x.fine) ? -1 : 1;
  const Result beyond = sum(-1, {Rational(sign)}, {x});
  return beyond && cln::zerop(beyond->fine) ? number(Rational(sign)) : x;
}

Result Arithmetic<Paired>::call(ir::Function function, const std::vector<Paired>& x) const {
  using ir::Function;
  const bool is_of_angle = function == Function::sin || function == Function::cos || function == Function::tan;
  // Two angles that have nothing to do with each other may have similar sines.
  if (is_of_angle && apart(x[0]) > rounding()) return Result::undefined(reason::k_rounding);
  if (function == Function::tan) {
    const Result bottom = call(Function::cos, x);
    if (!bottom) return bottom;
    if (cln::zerop(bottom->fine)) return Result::undefined(reason::k_pole);
  }
  const bool has_bound = function != Function::log && function != Function::atan2;
  if (!has_bound && !std::all_of(x.begin(), x.end(), [this](const Paired& entry) { return is_known(entry); }))
    return Result::undefined(reason::k_rounding);
  const bool is_arc = function == Function::asin || function == Function::acos;
  const std::vector<Paired> at = is_arc ? std::vector{within_arc(x[0])} : x;
  return settled(fine_.call(function, fine_of(at)), coarse_.call(function, coarse_of(at)), integer(1));
}

bool Arithmetic<Paired>::less(const Paired& a, const Paired& b) const {
  const Result apart = sum(0, {1, -1}, {b, a});
  return apart && is_known(*apart) && cln::plusp(apart->fine);
}

}  // namespace gaussgen::evaluate
