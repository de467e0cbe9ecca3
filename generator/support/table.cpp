#include "support/table.hpp"

#include <algorithm>

namespace gaussgen::support {

namespace {

template <class Number, class BeginOf>
const Table::Piece& last_reached(const Table& table, const Number& x, BeginOf begin_of) {
  const auto is_beyond = [&](const Number& value, const Table::Piece& piece) { return value < begin_of(piece); };
  const auto next = std::upper_bound(table.pieces.begin(), table.pieces.end(), x, is_beyond);
  return next == table.pieces.begin() ? *next : *(next - 1);
}

/// By Horner's rule.
template <class Number, class Convert>
Number polynomial(const std::vector<Rational>& coefficients, const Number& u, Convert convert) {
  Number value = 0;
  for (auto it = coefficients.rbegin(); it != coefficients.rend(); ++it) value = value * u + convert(*it);
  return value;
}

}  // namespace

const Table::Piece& piece_at(const Table& table, const Rational& x) {
  return last_reached(table, x, [](const Table::Piece& piece) { return piece.begin; });
}

const Table::Piece& piece_at(const Table& table, double x) {
  return last_reached(table, x, [](const Table::Piece& piece) { return to_double(piece.begin); });
}

std::vector<Rational> derivative(const Table::Piece& piece, int order) {
  std::vector<Rational> result = piece.coefficients;
  for (int n = 0; n < order && !result.empty(); ++n) {
    result.erase(result.begin());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] * cln::cl_I(static_cast<unsigned int>(i + 1));
  }
  return result;
}

Rational value_at(const Table& table, int order, const Rational& x) {
  const Table::Piece& piece = piece_at(table, x);
  const Rational u = x - piece.begin;
  return polynomial(derivative(piece, order), u, [](const Rational& c) { return c; });
}

double value_at(const Table& table, int order, double x) {
  const Table::Piece& piece = piece_at(table, x);
  const double u = x - to_double(piece.begin);
  return polynomial(derivative(piece, order), u, to_double) + (x - x);
}

}  // namespace gaussgen::support
