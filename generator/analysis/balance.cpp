#include "analysis/balance.hpp"

#include <cmath>

namespace gaussgen::analysis {

namespace {

constexpr Real k_enough = 0.95L;  ///< a change that wins less is none
constexpr int k_most_rounds = 100;

}  // namespace

Vector balance(const Matrix& given) {
  Matrix a = given;
  Vector d = Vector::Ones(a.rows());
  bool has_changed = true;
  for (int round = 0; has_changed && round < k_most_rounds; ++round) {
    has_changed = false;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      const Real diagonal = std::abs(a(i, i));
      const Real column = a.col(i).cwiseAbs().sum() - diagonal, row = a.row(i).cwiseAbs().sum() - diagonal;
      if (!(column > 0) || !(row > 0)) continue;
      const Real factor = std::exp2(std::round(std::log2(row / column) / 2));
      if (!(column * factor + row / factor < k_enough * (column + row))) continue;
      a.col(i) *= factor;
      a.row(i) /= factor;
      d[i] *= factor;
      has_changed = true;
    }
  }
  return d;
}

}  // namespace gaussgen::analysis
