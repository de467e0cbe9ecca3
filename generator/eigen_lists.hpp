#pragma once
// Lists of numbers as vectors and matrices of Eigen.

#include <vector>

#include "dense.hpp"

namespace gaussgen {

inline Eigen::Map<const Eigen::VectorXd> mapped(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

inline std::vector<double> unmapped(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

/// `columns`: of each row, of which there may be none.
inline Eigen::MatrixXd matrix_of(const std::vector<std::vector<double>>& rows, std::size_t columns) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = mapped(rows[i]);
  return result;
}

}  // namespace gaussgen
