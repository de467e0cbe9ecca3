#include "model/constant.hpp"

#include <cln/float.h>
#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/functions.hpp"
#include "support/assert.hpp"

namespace gaussgen::model {

using support::Rational;

namespace {

std::optional<Rational> power(const Rational& base, const Rational& exponent) {
  if (!support::is_integer(exponent)) return std::nullopt;
  const int n = support::to_int(exponent);
  if (n < 0 && cln::zerop(base)) return std::nullopt;
  return cln::expt(base, n);
}

std::optional<Rational> folded(const Ast& ast) {
  Rational value = ast.kind == AstKind::sum ? 0 : 1;
  for (const Ast& child : ast.children) {
    const auto part = exact_value(child);
    if (!part) return std::nullopt;
    value = ast.kind == AstKind::sum ? value + *part : value * *part;
  }
  return value;
}

/// Exact of exact arguments.
bool is_choice(const Ast& ast) {
  return ast.table != nullptr || ast.name == "abs" || ast.name == "sign" || ast.name == "min" || ast.name == "max" ||
         ast.name == k_piecewise;
}

/// Of conditions in their order, up to the first that holds.
std::optional<Rational> chosen_case(const Ast& ast) {
  for (std::size_t i = 0; i + 1 < ast.children.size(); i += 2) {
    const Ast& condition = ast.children[i];
    const auto a = exact_value(condition.children[0]);
    const auto b = exact_value(condition.children[1]);
    if (!a || !b) return std::nullopt;
    if (holds(condition.name, *a, *b)) return exact_value(ast.children[i + 1]);
  }
  return exact_value(ast.children.back());
}

std::optional<Rational> exact_call(const Ast& ast) {
  if (ast.name == k_piecewise) return chosen_case(ast);
  if (!is_choice(ast)) return std::nullopt;
  std::vector<Rational> values;
  for (const Ast& child : ast.children) {
    const auto value = exact_value(child);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  if (ast.table != nullptr) return support::value_at(*ast.table, 0, values[0]);
  if (ast.name == "abs") return cln::abs(values[0]);
  if (ast.name == "sign") return cln::signum(values[0]);
  return ast.name == "min" ? *std::min_element(values.begin(), values.end())
                           : *std::max_element(values.begin(), values.end());
}

double bits(const Rational& value) {
  return static_cast<double>(cln::integer_length(cln::numerator(value)) + cln::integer_length(cln::denominator(value)));
}

struct Size {
  double bits = 0;
  bool constant = true;
};

Size size_of(const Ast& ast, const BitsOfNames& names);

/// Constant terms are added up; terms that hold a symbol stay side by side.
Size size_of_sum(const Ast& ast, const BitsOfNames& names) {
  Size size;
  double largest = 0;
  for (const Ast& child : ast.children) {
    const Size part = size_of(child, names);
    if (part.constant) size.bits += part.bits;
    if (!part.constant) largest = std::max(largest, part.bits);
    size.constant = size.constant && part.constant;
  }
  size.bits += largest;
  return size;
}

Size size_of_symbol(const Ast& ast, const BitsOfNames& names) {
  const auto known = names.find(ast.name);
  return known == names.end() ? Size{1, false} : Size{known->second, true};
}

/// A cubic of a number has its bits three times, besides those of the coefficients; of a symbol nothing is computed.
Size size_of_table(const support::Table& table, const Size& argument) {
  if (!argument.constant) return {1, false};
  double largest = 0;
  for (const support::Table::Piece& piece : table.pieces) {
    double sum = 3 * bits(piece.begin);
    for (const Rational& coefficient : piece.coefficients) sum += bits(coefficient);
    largest = std::max(largest, sum);
  }
  return {largest + 3 * argument.bits, true};
}

Size size_of(const Ast& ast, const BitsOfNames& names) {
  if (ast.kind == AstKind::number) return {bits(ast.number), true};
  if (ast.kind == AstKind::symbol) return size_of_symbol(ast, names);
  if (ast.kind == AstKind::sum) return size_of_sum(ast, names);
  if (ast.kind == AstKind::power) {
    const Size base = size_of(ast.children[0], names);
    return {base.bits * std::max(1.0, std::abs(support::to_double(ast.children[1].number))), base.constant};
  }
  if (ast.table != nullptr) return size_of_table(*ast.table, size_of(ast.children[0], names));
  Size size;
  size.constant = ast.kind != AstKind::call || is_choice(ast);
  for (const Ast& child : ast.children) {
    const Size part = size_of(child, names);
    size.bits += part.bits;
    size.constant = size.constant && part.constant;
  }
  return size;
}

}  // namespace

std::optional<Rational> exact_value(const Ast& ast) {
  switch (ast.kind) {
    case AstKind::number: return ast.number;
    case AstKind::sum:
    case AstKind::product: return folded(ast);
    case AstKind::negate:
      if (const auto value = exact_value(ast.children[0])) return -*value;
      return std::nullopt;
    case AstKind::reciprocal: {
      const auto value = exact_value(ast.children[0]);
      if (!value || cln::zerop(*value)) return std::nullopt;
      return cln::recip(*value);
    }
    case AstKind::power: {
      const auto base = exact_value(ast.children[0]);
      const auto exponent = exact_value(ast.children[1]);
      if (!base || !exponent) return std::nullopt;
      return power(*base, *exponent);
    }
    case AstKind::call: return exact_call(ast);
    case AstKind::comparison:
    case AstKind::symbol: return std::nullopt;
  }
  support::fail(__FILE__, __LINE__, "kind", "kind={}", static_cast<int>(ast.kind));
}

bool is_in_range_of_double(const Rational& value) {
  const double size = std::abs(support::to_double(value));
  return value == 0 || (std::isfinite(size) && size >= std::numeric_limits<double>::min());
}

Rational pi_of_table() {
  constexpr int k_digits = 320;
  return cln::rational(cln::pi(cln::float_format(k_digits)));
}

double growth(const Ast& ast) { return growth(ast, {}); }

double growth(const Ast& ast, const BitsOfNames& names) { return size_of(ast, names).bits; }

}  // namespace gaussgen::model
