#include "lower/decimal_style.hpp"

#include <algorithm>

#include "model/expressions.hpp"

namespace gaussgen::lower {

namespace {

using support::Integer;
using support::Rational;

constexpr std::size_t k_most_places = 9;

bool is_dyadic(const Rational& value) { return cln::power2p(cln::denominator(value)) != 0; }

/// Of a positive number; nothing where the digits do not end soon.
std::optional<std::string> decimal(const Rational& value) {
  std::size_t places = 0;
  Rational shifted = value;
  for (; !support::is_integer(shifted); ++places) {
    if (places == k_most_places) return std::nullopt;
    shifted = shifted * 10;
  }
  std::string digits = support::to_text(shifted);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  return digits.insert(digits.size() - places, ".");
}

}  // namespace

DecimalStyle::DecimalStyle(const model::Model& model) {
  model::for_each_expression(model, [&](const model::Ast& ast, const model::Place& place) {
    if (&place != &model::parameter_place()) collect(ast);
  });
}

void DecimalStyle::collect(const model::Ast& ast) {
  if (ast.is_decimal && !is_dyadic(ast.number)) written_.push_back(ast.number);
  for (const model::Ast& child : ast.children) collect(child);
}

bool DecimalStyle::is_written(const Rational& value) const {
  return std::find(written_.begin(), written_.end(), value) != written_.end();
}

std::optional<std::string> DecimalStyle::operator()(const Rational& value) const {
  if (!is_used() || is_dyadic(value)) return std::nullopt;
  const Rational size = cln::abs(value);
  const auto text = decimal(size);
  if (!text || (!is_written(size) && text->size() >= support::to_text(size).size())) return std::nullopt;
  return (value < 0 ? "-" : "") + *text;
}

}  // namespace gaussgen::lower
