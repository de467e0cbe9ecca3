#pragma once
// A function of one argument that a model gives by points, as polynomials between them.

#include <string>
#include <vector>

#include "support/rational.hpp"

namespace gaussgen::support {

struct Table {
  /// Σ coefficients[i] u^i with u = x - begin.
  struct Piece {
    Rational begin = 0;
    std::vector<Rational> coefficients;
  };

  std::string name;
  std::string about;  ///< for readers of emitted code: what it is, how many points, its units
  /// The last piece that begins at or before x holds, the first one for all smaller x as well. All are of one length.
  std::vector<Piece> pieces;
  /// How often it can be differentiated; the last derivative jumps at the points.
  int derivatives = 0;

  std::size_t degree() const { return pieces.front().coefficients.size() - 1; }
};

const Table::Piece& piece_at(const Table& table, const Rational& x);
const Table::Piece& piece_at(const Table& table, double x);

/// i! / (i - order)! c_i for i from `order` on: the derivative of that order over the same u. Empty beyond the degree.
std::vector<Rational> derivative(const Table::Piece& piece, int order);

/// Of the derivative of that order; not a number where x is none.
Rational value_at(const Table& table, int order, const Rational& x);
double value_at(const Table& table, int order, double x);

}  // namespace gaussgen::support
