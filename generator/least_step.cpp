#include "least_step.hpp"

#include <algorithm>

namespace gaussgen {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 1 over the roots of inertias; of what has none, over the largest entry.
VectorXd scales_of(const MatrixXd& g, const MatrixXd& b) {
  VectorXd scales(g.rows());
  for (Index j = 0; j < g.rows(); ++j) {
    const double largest = b.col(j).lpNorm<Eigen::Infinity>();
    scales[j] = g(j, j) > 0 ? 1 / std::sqrt(g(j, j)) : largest > 0 ? 1 / largest : 1;
  }
  return scales;
}

/// Rows of unit length, and f in their units; a row of zeros says nothing.
void bring_to_unit_length(MatrixXd& b, VectorXd& f) {
  for (Index i = 0; i < b.rows(); ++i) {
    const double size = b.row(i).norm();
    b.row(i) = size > 0 ? VectorXd(b.row(i) / size).transpose() : VectorXd(VectorXd::Zero(b.cols())).transpose();
    f[i] = size > 0 ? f[i] / size : 0;
  }
}

/// G δ + Nᵀ λ = 0, N δ = c for orthonormal rows N.
VectorXd least_along(const MatrixXd& g, const MatrixXd& n, const VectorXd& c) {
  const Index size = g.rows(), rank = n.rows();
  MatrixXd all = MatrixXd::Zero(size + rank, size + rank);
  all.topLeftCorner(size, size) = g;
  all.bottomLeftCorner(rank, size) = n;
  all.topRightCorner(size, rank) = n.transpose();
  VectorXd right = VectorXd::Zero(size + rank);
  right.tail(rank) = c;
  return all.completeOrthogonalDecomposition().solve(right).head(size);
}

}  // namespace

VectorXd least_step(const MatrixXd& g, const MatrixXd& b, const VectorXd& f, double least_sine, Index usual) {
  if (g.rows() == 0 || b.rows() == 0) return VectorXd::Zero(g.rows());
  const VectorXd scales = scales_of(g, b);
  MatrixXd rows = b * scales.asDiagonal();
  VectorXd asked = f;
  bring_to_unit_length(rows, asked);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.transpose());
  Index rank = 0;
  const Index most = std::min(rows.rows(), rows.cols());
  while (rank < most && std::abs(qr.matrixQR()(rank, rank)) > (rank < usual ? least_sine : k_least_sine_beyond)) ++rank;
  if (rank == 0) return VectorXd::Zero(g.rows());
  const MatrixXd n = MatrixXd(qr.householderQ()).leftCols(rank).transpose();
  const VectorXd along = (rows * n.transpose()).completeOrthogonalDecomposition().solve(-asked);
  const MatrixXd metric = scales.asDiagonal() * g * scales.asDiagonal();
  return scales.asDiagonal() * least_along(metric, n, along);
}

}  // namespace gaussgen
