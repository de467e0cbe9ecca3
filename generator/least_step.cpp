#include "least_step.hpp"

#include <algorithm>
#include <vector>

#include "speed_scales.hpp"

namespace gaussgen {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd scales_of(const MatrixXd& g, const MatrixXd& b) {
  const VectorXd diagonal = g.diagonal();
  return scales_of_columns({diagonal.data(), diagonal.data() + diagonal.size()}, b);
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

constexpr double k_tie = 1e-6;  ///< of a length

Index longest_of(const MatrixXd& rows, Index preferred) {
  const VectorXd sizes = rows.rowwise().norm();
  const double least = (1 - k_tie) * sizes.maxCoeff();
  if (sizes[preferred] >= least) return preferred;
  Index first = 0;
  while (sizes[first] < least) ++first;
  return first;
}

/// By Gram and Schmidt, twice: rounding of the first time is across the directions before.
std::vector<Index> taken_rows(const MatrixXd& rows, double least_sine, Index usual, Index preferred) {
  std::vector<Index> taken;
  MatrixXd left = rows;
  const Index most = std::min({usual, rows.rows(), rows.cols()});
  while (static_cast<Index>(taken.size()) < most) {
    const Index next = longest_of(left, preferred);
    const double size = left.row(next).norm();
    if (!(size > least_sine)) break;
    taken.push_back(next);
    const VectorXd direction = left.row(next).transpose() / size;
    for (int pass = 0; pass < 2; ++pass) left -= (left * direction) * direction.transpose();
  }
  return taken;
}

}  // namespace

VectorXd scales_of_columns(const std::vector<double>& inertias, const MatrixXd& b) {
  const auto entry = [&](std::size_t i, std::size_t j) { return b(static_cast<Index>(i), static_cast<Index>(j)); };
  const std::vector<double> scales = speed_scales(inertias, static_cast<std::size_t>(b.rows()), entry, 0.0);
  return Eigen::Map<const VectorXd>(scales.data(), static_cast<Index>(scales.size()));
}

VectorXd emitted_step(const MatrixXd& g, const MatrixXd& b, const VectorXd& f, double least_sine, Index usual,
                      Index preferred) {
  if (g.rows() == 0 || b.rows() == 0) return VectorXd::Zero(g.rows());
  const VectorXd scales = scales_of(g, b);
  MatrixXd rows = b * scales.asDiagonal();
  VectorXd asked = f;
  bring_to_unit_length(rows, asked);
  const std::vector<Index> taken = taken_rows(rows, least_sine, usual, preferred);
  const auto rank = static_cast<Index>(taken.size());
  if (rank == 0) return VectorXd::Zero(g.rows());
  MatrixXd columns(rows.cols(), rank);
  VectorXd wanted(rank);
  for (Index k = 0; k < rank; ++k) {
    columns.col(k) = rows.row(taken[static_cast<std::size_t>(k)]).transpose();
    wanted[k] = -asked[taken[static_cast<std::size_t>(k)]];
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  const MatrixXd n = MatrixXd(qr.householderQ()).leftCols(rank).transpose();
  const VectorXd along = (n * columns).transpose().colPivHouseholderQr().solve(wanted);
  const MatrixXd metric = scales.asDiagonal() * g * scales.asDiagonal();
  return scales.asDiagonal() * least_along(metric, n, along);
}

VectorXd least_step(const MatrixXd& g, const MatrixXd& b, const VectorXd& f, double least_sine) {
  if (g.rows() == 0 || b.rows() == 0) return VectorXd::Zero(g.rows());
  const VectorXd scales = scales_of(g, b);
  MatrixXd rows = b * scales.asDiagonal();
  VectorXd asked = f;
  bring_to_unit_length(rows, asked);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.transpose());
  Index rank = 0;
  const Index most = std::min(rows.rows(), rows.cols());
  while (rank < most && std::abs(qr.matrixQR()(rank, rank)) > least_sine) ++rank;
  if (rank == 0) return VectorXd::Zero(g.rows());
  const MatrixXd n = MatrixXd(qr.householderQ()).leftCols(rank).transpose();
  const VectorXd along = (rows * n.transpose()).completeOrthogonalDecomposition().solve(-asked);
  const MatrixXd metric = scales.asDiagonal() * g * scales.asDiagonal();
  return scales.asDiagonal() * least_along(metric, n, along);
}

}  // namespace gaussgen
