#include "chart_map.hpp"

#include <cmath>

#include "evaluation.hpp"

namespace gaussgen {

namespace {

constexpr double k_speed = 0.7;  ///< of every speed, each a little apart: constraints need not be linear in them

/// Columns of free speeds of ∂v/∂ẏ^A.
std::vector<std::vector<ir::NodeId>> rows_of(const support::Indexed<kinematics::FullIndex, ir::Vector3>& columns,
                                             const kinematics::Symbols& symbols) {
  std::vector<std::vector<ir::NodeId>> rows(3);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const auto i : symbols.speeds.indices()) rows[k].push_back(columns[symbols.full(i)][k].id());
  }
  return rows;
}

/// L with LᵀL = I; of what no body has, the part that one could have.
Eigen::Matrix3d root(const Eigen::Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  const Eigen::Vector3d moments = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  return moments.asDiagonal() * axes.eigenvectors().transpose();
}

}  // namespace

ChartMap::ChartMap(const Mechanics& mechanics)
    : own_(mechanics.model, mechanics.options.fold, mechanics.options.most_nodes),
      values_(own_.graph, evaluate::Arithmetic<double>()) {
  for (const kinematics::BodyMotion& motion : *own_.kinematics.bodies) {
    Body body{motion.mass.id(), motion.is_rigid, {}, rows_of(motion.J, own_.symbols), {}};
    if (motion.is_rigid) {
      body.W = rows_of(motion.W, own_.symbols);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) body.inertia.push_back(motion.inertia[i][j].id());
      }
    }
    inertial_rows_ += motion.is_rigid ? 6 : 3;
    bodies_.push_back(std::move(body));
  }
  for (const kinematics::ConstraintRow& row : own_.kinematics.constraints) {
    constraints_.emplace_back();
    for (const auto i : own_.symbols.speeds.indices())
      constraints_.back().push_back(row.beta[own_.symbols.full(i)].id());
  }
  bind_parameters(own_, values_);
  values_.bind(own_.symbols.time, 0);
}

void ChartMap::bind(const std::vector<double>& configuration) {
  for (const auto i : own_.symbols.configuration.indices())
    values_.bind(own_.symbols.configuration[i].symbol, configuration[i.value]);
  for (const auto i : own_.symbols.speeds.indices())
    values_.bind(own_.symbols.speeds[i].symbol, k_speed * (1 + 0.37 * static_cast<double>(i.value)));
}

std::optional<Eigen::MatrixXd> ChartMap::values(const Rows& rows) {
  const auto columns = static_cast<Eigen::Index>(own_.symbols.speeds.size());
  Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), columns);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) {
      const auto value = values_(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
      if (!value || !std::isfinite(*value)) return std::nullopt;
      result(i, j) = *value;
    }
  }
  return result;
}

// 2 T = Σ m |v|² + ω·I ω
bool ChartMap::add(const Body& body, Eigen::Index& row, Eigen::MatrixXd& result) {
  const auto mass = values_(body.mass);
  const auto J = values(body.J);
  if (!mass || !J || !std::isfinite(*mass)) return false;
  result.middleRows(row, 3) = std::sqrt(std::max(*mass, 0.0)) * *J;
  row += 3;
  if (!body.is_rigid) return true;
  Eigen::Matrix3d inertia;
  for (int k = 0; k < 9; ++k) {
    const auto entry = values_(body.inertia[static_cast<std::size_t>(k)]);
    if (!entry || !std::isfinite(*entry)) return false;
    inertia(k / 3, k % 3) = *entry;
  }
  const auto W = values(body.W);
  if (!W) return false;
  result.middleRows(row, 3) = root(inertia) * *W;
  row += 3;
  return true;
}

std::optional<Eigen::MatrixXd> ChartMap::operator()(const std::vector<double>& configuration) {
  bind(configuration);
  const auto b = values(constraints_);
  if (!b) return std::nullopt;
  Eigen::MatrixXd result(inertial_rows_ + b->rows(), b->cols());
  Eigen::Index row = 0;
  for (const Body& body : bodies_) {
    if (!add(body, row, result)) return std::nullopt;
  }
  result.bottomRows(b->rows()) = *b;
  return result;
}

// The rates are linear in the speeds: a column is what one speed adds to those without any.
std::optional<Eigen::MatrixXd> ChartMap::rates(const std::vector<double>& configuration) {
  bind(configuration);
  const auto n = static_cast<Eigen::Index>(own_.symbols.plain_count());
  Eigen::MatrixXd result(n, n + 1);
  for (Eigen::Index j = n; j >= 0; --j) {
    for (const auto i : own_.symbols.speeds.indices())
      values_.bind(own_.symbols.speeds[i].symbol, static_cast<Eigen::Index>(i.value) == j ? 1 : 0);
    for (Eigen::Index i = 0; i < n; ++i) {
      const kinematics::ConfigurationIndex index{static_cast<std::size_t>(i)};
      const auto rate = values_(own_.kinematics.configuration_rates[index].id());
      if (!rate || !std::isfinite(*rate)) return std::nullopt;
      result(i, j) = *rate;
    }
  }
  // Where quaternions follow, the speed of index n is none of the plain ones: it moves none of these coordinates.
  return result.leftCols(n).colwise() - result.col(n);
}

}  // namespace gaussgen
