#include "emit/literal.hpp"

#include <cln/dfloat.h>
#include <cln/float.h>

#include <array>
#include <charconv>
#include <climits>

namespace gaussgen::emit {

using cpp::Expression;
using support::Rational;

namespace {

const Rational k_range = cln::expt_pos(cln::cl_I(2), 100);

/// Whether float has it exactly: else an S that is a batch of float would be made from a literal that is rounded on the way,
/// which compilers warn of.
bool is_whole_float(const Rational& value) {
  if (!support::is_integer(value) || cln::abs(value) > k_range) return false;
  const cln::cl_I size = cln::abs(cln::numerator(value));
  const cln::cl_I odd_part = cln::zerop(size) ? size : cln::ash(size, -cln::cl_I(cln::ord2(size)));
  return odd_part < cln::expt_pos(cln::cl_I(2), 24);
}

// 1/2, 3/8, 0.09375: exact in binary, also in float if the numerator is small.
bool is_dyadic(const Rational& value) {
  const cln::cl_I bottom = cln::denominator(value);
  return cln::power2p(bottom) != 0 && bottom <= k_range && is_whole_float(cln::numerator(value));
}

// The shortest text that reads back as the same double, in any locale, and is no integer literal.
std::string text_of(double value) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), end);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

Expression of_scalar(std::string text) { return cpp::call("S", {cpp::atom(std::move(text))}); }

Expression whole(const Rational& value) {
  if (cln::abs(value) <= INT_MAX) return of_scalar(std::to_string(support::to_int(value)));
  return of_scalar(text_of(support::to_double(value)));
}

Expression in_pieces(const Rational& value) {
  std::vector<Expression> pieces;
  Rational rest = value;
  for (int i = 0; i < 3; ++i) {
    const double piece = support::to_double(rest);
    pieces.push_back(cpp::atom(text_of(piece)));
    rest = rest - cln::rational(cln::cl_DF(piece));
  }
  return cpp::call("Math<S>::constant", std::move(pieces));
}

}  // namespace

bool is_single_literal(const Rational& value) {
  const bool is_quotient = is_whole_float(cln::numerator(value)) && is_whole_float(cln::denominator(value));
  return support::is_integer(value) || is_dyadic(value) || !is_quotient;
}

Expression literal(const Rational& value) {
  if (value < 0) return cpp::negated(literal(-value));
  if (is_whole_float(value)) return whole(value);
  if (is_dyadic(value)) return of_scalar(text_of(support::to_double(value)));
  if (is_single_literal(value)) return in_pieces(value);
  return cpp::quotient(whole(cln::numerator(value)), whole(cln::denominator(value)));
}

std::string decimal_text(const Rational& value) {
  Rational rest = cln::denominator(value);
  for (const int prime : {2, 5}) {
    while (support::is_integer(rest / prime)) rest = rest / prime;
  }
  return rest == 1 && cln::denominator(value) <= cln::expt_pos(cln::cl_I(10), 12)
             ? (support::is_integer(value) ? support::to_text(value) : text_of(support::to_double(value)))
             : support::to_text(value);
}

}  // namespace gaussgen::emit
