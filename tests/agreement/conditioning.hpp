#pragma once
// How far rounding may reach in the linear problem of a state.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mechanics.hpp"
#include "models.hpp"

namespace agreement {

using gaussgen::evaluate::Evaluator;

inline constexpr double k_eps = 2.220446049250313e-16;
inline constexpr double k_largest_condition = 1e8;

template <class T>
Eigen::VectorXd values(Evaluator<T>& evaluator, const std::vector<gaussgen::ir::NodeId>& nodes) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto value = evaluator(nodes[i]);
    result[static_cast<Eigen::Index>(i)] = value ? static_cast<double>(*value) : std::nan("");
  }
  return result;
}

inline std::vector<gaussgen::ir::NodeId> nodes(const gaussgen::strategy::Vector& v) {
  std::vector<gaussgen::ir::NodeId> result;
  for (const auto e : v) result.push_back(e.id());
  return result;
}

inline Eigen::MatrixXd matrix(Evaluator<double>& evaluator, const gaussgen::strategy::Matrix& m, Eigen::Index columns) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(m.size()), columns);
  for (Eigen::Index i = 0; i < result.rows(); ++i)
    result.row(i) = values(evaluator, nodes(m[static_cast<std::size_t>(i)]));
  return result;
}

/// The problem in units in which masses and constraint rows are of size 1.
struct Scaling {
  Eigen::VectorXd speed;       ///< sqrt(g_αα)
  Eigen::VectorXd constraint;  ///< length of each row of b in the mass metric
  double condition = 1;        ///< of the scaled g and, with constraints, of the scaled [g bᵀ; b 0]
};

inline double condition(const Eigen::MatrixXd& m) {
  const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(m).singularValues();
  return s.size() == 0 ? 1.0 : s[0] / s[s.size() - 1];
}

inline Scaling scaling(Evaluator<double>& evaluator, const gaussgen::strategy::Dynamics& dynamics) {
  const auto n = static_cast<Eigen::Index>(dynamics.n());
  const auto l = static_cast<Eigen::Index>(dynamics.l());
  const Eigen::MatrixXd g = matrix(evaluator, dynamics.g, n);
  const Eigen::MatrixXd b = matrix(evaluator, dynamics.b, n);
  Scaling result;
  result.speed = g.diagonal().cwiseSqrt();
  const Eigen::VectorXd inverse = result.speed.cwiseInverse();
  const Eigen::MatrixXd scaled_g = inverse.asDiagonal() * g * inverse.asDiagonal();
  const Eigen::MatrixXd rows = b * inverse.asDiagonal();
  result.constraint = rows.rowwise().norm();
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + l, n + l);
  kkt.topLeftCorner(n, n) = scaled_g;
  if (l > 0) {
    const Eigen::MatrixXd unit_rows = result.constraint.cwiseInverse().asDiagonal() * rows;
    kkt.bottomLeftCorner(l, n) = unit_rows;
    kkt.topRightCorner(n, l) = unit_rows.transpose();
  }
  result.condition = std::max(condition(scaled_g), condition(kkt));
  return result;
}

/// Keeps the larger one. NaN compares false everywhere: it is taken as a failure.
inline void take(double& worst, double now) {
  if (!(now <= worst)) worst = now;
}

}  // namespace agreement
