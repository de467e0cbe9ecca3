#pragma once

#include <cstddef>
#include <vector>

#include "analysis/matrix.hpp"

namespace gaussgen::analysis {

/// A solution v exp(s t) of x' = A x.
struct Mode {
  Complex eigenvalue;
  /// Over all variables. The largest of those that make the eigenvalue is 1; those that only follow them may be larger. Empty where the
  /// eigenvalue is 0.
  ComplexVector shape;
  std::vector<std::size_t> makers;  ///< variables that depend on each other: their block
};

/// As many as variables: from the least stable on, conjugate ones beside each other, those that are 0 at the end.
std::vector<Mode> modes(const Matrix& a);

}  // namespace gaussgen::analysis
