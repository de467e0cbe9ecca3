#pragma once

#include <cstddef>
#include <vector>

#include "analysis/matrix.hpp"

namespace gaussgen::analysis {

/// Which of some variables homogeneous linear equations determine by the others.
struct Independent {
  std::vector<std::size_t> independent;  ///< columns, in order
  std::vector<std::size_t> dependent;    ///< paired with `rows`
  std::vector<std::size_t> rows;         ///< equations that say so; the others follow from them
};

/// Of equations `rows * x = 0`. The higher the preference of a column (above 0), the sooner it becomes dependent; among equal ones the
/// later one does. A pivot is at least a hundredth of what the best column of like preference offers, so that none is divided by what is
/// nearly nothing.
Independent choose_independent(const Matrix& rows, const std::vector<double>& preference);

}  // namespace gaussgen::analysis
