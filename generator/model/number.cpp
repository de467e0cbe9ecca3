#include "model/number.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "model/lexer.hpp"
#include "support/characters.hpp"

namespace gaussgen::model {

using support::Integer;
using support::Rational;

using support::is_digit;

namespace {

std::size_t digits_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - at;
}

char at(std::string_view text, std::size_t i) { return i < text.size() ? text[i] : '\0'; }

struct Parts {
  std::string digits;        // of the mantissa, without the point
  std::size_t fraction = 0;  // how many of them follow the point
  std::string exponent;      // with its sign
  std::size_t size = 0;
};

Parts split(std::string_view text) {
  Parts parts;
  std::size_t i = digits_at(text, 0);
  parts.digits = text.substr(0, i);
  if (at(text, i) == '.') {
    parts.fraction = digits_at(text, i + 1);
    parts.digits += text.substr(i + 1, parts.fraction);
    i += 1 + parts.fraction;
  }
  if (at(text, i) == 'e' || at(text, i) == 'E') {
    const std::size_t sign = at(text, i + 1) == '+' || at(text, i + 1) == '-' ? 1 : 0;
    const std::size_t length = digits_at(text, i + 1 + sign);
    if (length > 0) {
      parts.exponent = text.substr(i + 1, sign + length);
      i += 1 + sign + length;
    }
  }
  parts.size = i;
  return parts;
}

Integer integer_of(std::string_view digits) {
  Integer value = 0;
  for (const char c : digits) value = value * 10 + (c - '0');
  return value;
}

/// Clamped just above the limit, so that a long row of digits cannot overflow.
int small_exponent(const std::string& text) {
  int value = 0;
  for (const char c : text) {
    if (is_digit(c) && value <= k_largest_decimal_exponent) value = value * 10 + (c - '0');
  }
  return !text.empty() && text[0] == '-' ? -value : value;
}

Rational scaled(const Integer& mantissa, int exponent) {
  if (exponent == 0) return mantissa;
  const Integer power = cln::expt_pos(Integer(10), Integer(std::abs(exponent)));
  return exponent > 0 ? Rational(mantissa * power) : mantissa / power;
}

/// 0x1F, 0o17, 0b1
bool has_base(std::string_view text) {
  const char base = at(text, 1);
  if (text[0] != '0') return false;
  return base == 'x' || base == 'X' || ((base == 'o' || base == 'b') && is_digit(at(text, 2)));
}

/// What stands behind the digits of 1e and 1e-.
bool lacks_exponent(std::string_view rest) {
  if (at(rest, 0) != 'e' && at(rest, 0) != 'E') return false;
  const char next = at(rest, 1);
  return !support::is_name_character(next) && next != '(' && next != '.';
}

NumberScan refused(std::size_t size, std::string problem, std::string hint) {
  NumberScan scan;
  scan.size = size;
  scan.problem = std::move(problem);
  scan.hint = std::move(hint);
  return scan;
}

}  // namespace

NumberScan scan_number(std::string_view text) {
  if (has_base(text)) {
    return refused(2, fmt::format("numbers are decimal; '{}' has no meaning here", text.substr(0, 2)),
                   "write the value in decimal digits");
  }
  const Parts parts = split(text);
  if (lacks_exponent(text.substr(parts.size))) {
    return refused(parts.size + 1, fmt::format("the exponent of '{}' is missing", text.substr(0, parts.size + 1)),
                   "write its digits, as in 1e3, or * for a product");
  }
  if (at(text, parts.size) == '.') {
    return refused(parts.size + 1, "a number with two decimal points", "write one, as in 1.5");
  }
  if (at(text, parts.size) == '_') {
    return refused(parts.size + 1, "digits cannot be grouped by '_'", "write them without a separator");
  }
  if (parts.digits.size() > k_most_digits) {
    return refused(parts.size,
                   fmt::format("a number with {} digits; the limit is {}", parts.digits.size(), k_most_digits),
                   "17 digits are as many as double holds");
  }
  const int exponent = small_exponent(parts.exponent);
  if (exponent > k_largest_decimal_exponent || exponent < -k_largest_decimal_exponent) {
    NumberScan scan = refused(parts.size, exponent > 0 ? k_too_large : k_too_small, k_hint_for_range);
    scan.code = &support::code::k_not_finite;
    return scan;
  }
  NumberScan scan;
  scan.size = parts.size;
  scan.value = scaled(integer_of(parts.digits), exponent - static_cast<int>(parts.fraction));
  return scan;
}

}  // namespace gaussgen::model
