#include "rest_step.hpp"

#include <algorithm>
#include <cmath>

namespace gaussgen {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double k_held = 1e-10;        ///< of the largest singular value: a constraint that says something of its own
constexpr double k_least_column = 0.1;  ///< of the largest: however heavy, what could move does
constexpr double k_ease = 10;           ///< of multipliers: they take what they can before anything moves

/// Per unknown, so that all are of like size: displacements as masses measure them.
VectorXd weights(const RestUnknowns& unknowns) {
  const Index n = unknowns.masses.size();
  const VectorXd& effects = unknowns.effects;
  VectorXd result = VectorXd::Ones(effects.size());
  double largest = 0, lightest = 0;
  for (Index j = 0; j < n; ++j) {
    const double g = unknowns.masses[j];
    result[j] = g > 0 ? 1 / std::sqrt(g) : 0;
    largest = std::max(largest, result[j] * effects[j]);
    lightest = std::max(lightest, result[j]);
  }
  for (Index j = 0; j < effects.size(); ++j) {
    const bool is_multiplier = j >= n;
    if (effects[j] == 0) {
      // It moves with what does have an effect, where a constraint says so.
      result[j] = result[j] > 0 && largest > 0 ? result[j] / largest : 1;
    } else if (is_multiplier || result[j] == 0 || largest == 0) {
      result[j] = (is_multiplier ? k_ease : 1) / effects[j];
    } else {
      // No lighter than the lightest: where a force hardly acts, as on a heading, nothing has to move for that.
      result[j] = std::max(result[j] / largest, std::min(k_least_column / effects[j], lightest / largest));
    }
  }
  return result;
}

/// Orthonormal changes, in units of the weights, that constraints on velocities allow: what rolls moves as it turns.
MatrixXd allowed_ways(const RestUnknowns& unknowns, const VectorXd& weight) {
  const Index n = unknowns.masses.size(), all = weight.size();
  if (unknowns.held.rows() == 0 || n == 0) return MatrixXd::Identity(all, all);
  MatrixXd b = unknowns.held * weight.head(n).asDiagonal();
  for (Index mu = 0; mu < b.rows(); ++mu) {
    const double size = b.row(mu).norm();
    if (size > 0) b.row(mu) /= size;
  }
  const MatrixXd open = open_ways(b);
  const Index free = open.cols();
  MatrixXd ways = MatrixXd::Zero(all, free + all - n);
  ways.topLeftCorner(n, free) = open;
  ways.bottomRightCorner(all - n, all - n).setIdentity();
  return ways;
}

}  // namespace

MatrixXd open_ways(const MatrixXd& rows) {
  if (rows.rows() == 0) return MatrixXd::Identity(rows.cols(), rows.cols());
  Eigen::JacobiSVD<MatrixXd> svd(rows, Eigen::ComputeFullV);
  svd.setThreshold(k_held);
  return svd.matrixV().rightCols(rows.cols() - svd.rank());
}

RestStep::RestStep(const MatrixXd& matrix, const RestUnknowns& unknowns) {
  const VectorXd weight = weights(unknowns);
  ways_ = weight.asDiagonal() * allowed_ways(unknowns, weight);
  matrix_ = matrix * ways_;
}

VectorXd RestStep::least(const VectorXd& right, double rank) const {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(rank);
  decomposition.compute(matrix_);
  return ways_ * decomposition.solve(right);
}

VectorXd RestStep::damped(const VectorXd& right, double damping) const {
  const Index count = ways_.cols();
  MatrixXd stacked(right.size() + count, count);
  stacked << matrix_, std::sqrt(damping) * MatrixXd::Identity(count, count);
  VectorXd all = VectorXd::Zero(right.size() + count);
  all.head(right.size()) = right;
  return ways_ * stacked.colPivHouseholderQr().solve(all);
}

}  // namespace gaussgen
