#include "rest_slope.hpp"

#include <algorithm>
#include <cmath>

#include "rest_step.hpp"

namespace gaussgen {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double k_massless = 1e-9;   ///< of the largest mass: what moves without any
constexpr double k_no_slope = 1e-10;  ///< of the largest stiffness: rounding

}  // namespace

RestSlope::RestSlope(const RestForces& here) {
  const MatrixXd ways = open_ways(here.rows);
  if (ways.cols() == 0) return;
  const MatrixXd stiffness = ways.transpose() * (here.stiffness + here.stiffness.transpose()) * ways / 2;
  MatrixXd mass = ways.transpose() * here.metric * ways;
  const double largest = mass.diagonal().maxCoeff();
  mass += MatrixXd::Identity(mass.rows(), mass.cols()) * (largest > 0 ? k_massless * largest : 1);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(stiffness, mass);
  stiffness_ = modes.eigenvalues();
  shapes_ = ways * modes.eigenvectors();
  force_ = shapes_.transpose() * here.force;
}

bool RestSlope::is_bottom() const {
  return stiffness_.size() == 0 || stiffness_.minCoeff() >= -k_no_slope * stiffness_.cwiseAbs().maxCoeff();
}

VectorXd RestSlope::downhill(const VectorXd& longest) const {
  VectorXd way = VectorXd::Zero(longest.size());
  for (Index i = 0; i < force_.size(); ++i) {
    const double most = 1 / shapes_.col(i).cwiseAbs().cwiseQuotient(longest).maxCoeff();
    const double wanted = std::abs(force_[i]) / std::abs(stiffness_[i]);
    if (force_[i] != 0) way += std::copysign(wanted < most ? wanted : most, force_[i]) * shapes_.col(i);
  }
  const double excess = way.cwiseAbs().cwiseQuotient(longest).maxCoeff();
  return excess > 1 ? VectorXd(way / excess) : way;
}

}  // namespace gaussgen
