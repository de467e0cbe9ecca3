#include "model/points.hpp"

namespace gaussgen::model {

using support::Rational;
using Piece = support::Table::Piece;

namespace {

/// Second derivatives M at the points of the natural cubic spline, 0 at both ends (Press et al., Numerical Recipes, 3.3):
///   h_{k-1} M_{k-1} + 2 (h_{k-1} + h_k) M_k + h_k M_{k+1} = 6 (s_k - s_{k-1}), h widths and s slopes of the intervals.
/// Elimination without pivoting: the matrix is diagonally dominant.
std::vector<Rational> second_derivatives(const std::vector<Rational>& h, const std::vector<Rational>& s) {
  const std::size_t last = h.size();
  std::vector<Rational> pivot(last + 1, 0), right(last + 1, 0), result(last + 1, 0);
  for (std::size_t k = 1; k < last; ++k) {
    pivot[k] = 2 * (h[k - 1] + h[k]);
    right[k] = 6 * (s[k] - s[k - 1]);
    if (k == 1) continue;
    const Rational factor = h[k - 1] / pivot[k - 1];
    pivot[k] = pivot[k] - factor * h[k - 1];
    right[k] = right[k] - factor * right[k - 1];
  }
  for (std::size_t k = last - 1; k > 0; --k) result[k] = (right[k] - h[k] * result[k + 1]) / pivot[k];
  return result;
}

std::vector<Piece> between(const Points& points, Table::Kind kind) {
  std::vector<Rational> h, s;
  for (std::size_t k = 0; k + 1 < points.of.size(); ++k) {
    h.push_back(points.of[k + 1] - points.of[k]);
    s.push_back((points.values[k + 1] - points.values[k]) / h[k]);
  }
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < h.size(); ++k) pieces.push_back({points.of[k], {points.values[k], s[k]}});
  if (kind == Table::Kind::linear) return pieces;
  const std::vector<Rational> m = second_derivatives(h, s);
  for (std::size_t k = 0; k < h.size(); ++k) {
    pieces[k].coefficients[1] = s[k] - h[k] * (2 * m[k] + m[k + 1]) / 6;
    pieces[k].coefficients.push_back(m[k] / 2);
    pieces[k].coefficients.push_back((m[k + 1] - m[k]) / (6 * h[k]));
  }
  return pieces;
}

/// value + slope u from `begin` on, with as many coefficients as others have.
Piece straight(const Rational& begin, const Rational& value, const Rational& slope, std::size_t size) {
  Piece piece{begin, {value, slope}};
  piece.coefficients.resize(size, 0);
  return piece;
}

Rational slope_at_end(const Piece& last, const Rational& end) {
  const std::vector<Rational> slopes = support::derivative(last, 1);
  const Rational u = end - last.begin;
  Rational slope = 0;
  for (auto it = slopes.rbegin(); it != slopes.rend(); ++it) slope = slope * u + *it;
  return slope;
}

}  // namespace

std::vector<Piece> pieces_through(const Points& points, Table::Kind kind, Table::Outside outside) {
  std::vector<Piece> pieces = between(points, kind);
  const bool is_held = outside == Table::Outside::hold;
  if (kind == Table::Kind::linear && !is_held) return pieces;  // the outer intervals go on
  const std::size_t size = pieces[0].coefficients.size();
  const Rational first_slope = is_held ? Rational(0) : pieces.front().coefficients[1];
  const Rational last_slope = is_held ? Rational(0) : slope_at_end(pieces.back(), points.of.back());
  pieces.insert(pieces.begin(), straight(points.of.front(), points.values.front(), first_slope, size));
  pieces.push_back(straight(points.of.back(), points.values.back(), last_slope, size));
  return pieces;
}

int derivatives_of(Table::Kind kind, Table::Outside outside) {
  return kind == Table::Kind::spline && outside == Table::Outside::extend ? 3 : 1;
}

}  // namespace gaussgen::model
