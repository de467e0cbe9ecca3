#include "analysis/independent.hpp"

#include <algorithm>
#include <cmath>

namespace gaussgen::analysis {

namespace {

constexpr Real k_nothing = 1e-12L;  ///< of a row, against 1 at its largest
constexpr Real k_near_best = 0.01L;

/// Gauss and Jordan with the pivot that counts most: its size times the preference of its column.
class Elimination {
 public:
  Elimination(Matrix rows, const std::vector<double>& preference) : rows_(std::move(rows)), preference_(preference) {
    for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
      const Real size = rows_.row(i).lpNorm<Eigen::Infinity>();
      if (size > 0) rows_.row(i) /= size;
    }
    row_used_.assign(static_cast<std::size_t>(rows_.rows()), false);
    column_used_.assign(static_cast<std::size_t>(rows_.cols()), false);
  }

  Independent run() {
    Independent result;
    for (Eigen::Index row = 0, column = 0; find_pivot(row, column);) {
      result.rows.push_back(static_cast<std::size_t>(row));
      result.dependent.push_back(static_cast<std::size_t>(column));
      clear(row, column);
    }
    for (std::size_t j = 0; j < column_used_.size(); ++j) {
      if (!column_used_[j]) result.independent.push_back(j);
    }
    return result;
  }

 private:
  Real worth(Eigen::Index i, Eigen::Index j) const {
    const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
    if (row_used_[row] || column_used_[column] || !(std::abs(rows_(i, j)) > k_nothing)) return 0;
    return std::abs(rows_(i, j)) * static_cast<Real>(preference_[column]);
  }

  bool find_pivot(Eigen::Index& row, Eigen::Index& column) const {
    Real best = 0;
    for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
      for (Eigen::Index j = 0; j < rows_.cols(); ++j) best = std::max(best, worth(i, j));
    }
    if (best == 0) return false;
    // The last column that does nearly as well, and there the largest entry.
    column = -1;
    Real largest = 0;
    for (Eigen::Index j = rows_.cols() - 1; j >= 0 && column < 0; --j) {
      for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
        if (worth(i, j) < k_near_best * best || worth(i, j) <= largest) continue;
        largest = worth(i, j);
        row = i;
        column = j;
      }
    }
    return true;
  }

  void clear(Eigen::Index row, Eigen::Index column) {
    row_used_[static_cast<std::size_t>(row)] = true;
    column_used_[static_cast<std::size_t>(column)] = true;
    rows_.row(row) /= rows_(row, column);
    for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
      if (i != row) rows_.row(i) -= rows_(i, column) * rows_.row(row);
    }
  }

  Matrix rows_;
  const std::vector<double>& preference_;
  std::vector<bool> row_used_, column_used_;
};

}  // namespace

Independent choose_independent(const Matrix& rows, const std::vector<double>& preference) {
  return Elimination(rows, preference).run();
}

}  // namespace gaussgen::analysis
