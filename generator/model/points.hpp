#pragma once
// Polynomials through points.

#include <vector>

#include "model/model.hpp"

namespace gaussgen::model {

struct Points {
  std::vector<support::Rational> of;  ///< growing
  std::vector<support::Rational> values;
};

/// The pieces of a table: between the points, and outside of them. Exact.
std::vector<support::Table::Piece> pieces_through(const Points& points, Table::Kind kind, Table::Outside outside);

/// How often such a function can be differentiated.
int derivatives_of(Table::Kind kind, Table::Outside outside);

}  // namespace gaussgen::model
