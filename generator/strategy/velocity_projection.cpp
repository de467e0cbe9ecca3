#include "strategy/velocity_projection.hpp"

#include <algorithm>

#include "ir/rounded.hpp"
#include "strategy/inner.hpp"
#include "strategy/least_change.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConstraintIndex;

namespace {

Vector restricted(const Vector& row, const std::vector<std::size_t>& to) {
  Vector result;
  for (const std::size_t i : to) result.push_back(row[i]);
  return result;
}

bool contains(const std::vector<std::size_t>& all, std::size_t one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

VelocityProjection::VelocityProjection(const Dynamics& dynamics, std::vector<std::size_t> moving, Expr epsilon)
    : dynamics_(dynamics),
      moving_(std::move(moving)),
      dependent_rows_(dependent_rows_over(dynamics, moving_)),
      epsilon_(epsilon),
      singular_(epsilon.graph(), epsilon.graph().constant(0)),
      dependent_(singular_) {}

std::vector<std::size_t> VelocityProjection::movable(const VelocityProblem& at) const {
  std::vector<std::size_t> rows;
  for (std::size_t mu = 0; mu < at.b.size(); ++mu) {
    if (std::any_of(moving_.begin(), moving_.end(), [&](std::size_t i) { return !at.b[mu][i].is_zero(); }))
      rows.push_back(mu);
  }
  return rows;
}

std::vector<std::size_t> VelocityProjection::to_be_checked(const std::vector<std::size_t>& movable) const {
  std::vector<std::size_t> rows;
  for (const ConstraintIndex mu : dynamics_.kinematics->constraints.indices()) {
    if (!dynamics_.kinematics->constraints[mu].is_linear || !contains(movable, mu.value)) rows.push_back(mu.value);
  }
  return rows;
}

Solution VelocityProjection::change(const VelocityProblem& at, const std::vector<std::size_t>& movable,
                                    const std::string& prefix, Steps& steps) const {
  const Change wanted{moving_, movable, restricted(at.phi, movable), prefix};
  if (!at.g) return least_change(dynamics_, wanted, dependent_rows_, epsilon_, steps);
  Dynamics there = dynamics_;
  there.b = at.b;
  there.g = *at.g;
  there.change_of_links = nullptr;
  return least_change(there, wanted, dependent_rows_, epsilon_, steps);
}

void VelocityProjection::step(const VelocityProblem& at, const std::vector<std::size_t>& movable,
                              const std::string& prefix, Vector& speeds, Steps& steps) {
  if (movable.empty()) return;
  steps.begin("smallest change of the speeds in the mass metric that satisfies the constraints");
  const Solution found = change(at, movable, prefix, steps);
  for (std::size_t j = 0; j < moving_.size(); ++j) {
    Expr& speed = speeds[moving_[j]];
    speed = steps.name(ir::rounded(speed + found.accelerations[j]), prefix + dynamics_.labels[moving_[j]] + "_rate");
  }
  ir::Graph& graph = epsilon_.graph();
  singular_ = any(graph, {singular_, found.singular_mass_matrix});
  dependent_ = any(graph, {dependent_, found.dependent_constraints, lost(at, movable)});
}

// Whether a constraint says something of given speeds alone here, and of those that may move only what rounding has left. The 1000
// covers what sums of products lose; squares, since a row has no sign.
Expr VelocityProjection::lost(const VelocityProblem& at, const std::vector<std::size_t>& movable) const {
  ir::Graph& graph = epsilon_.graph();
  std::vector<Expr> conditions;
  for (const std::size_t mu : movable) {
    const Expr all = inner(graph, at.b[mu], at.b[mu]);
    const Vector moving = restricted(at.b[mu], moving_);
    const Expr of_moving = inner(graph, moving, moving);
    if (!(of_moving == all))
      conditions.push_back(less(of_moving, support::Rational(1'000'000) * pow(epsilon_, 2) * all));
  }
  return any(graph, conditions);
}

// Squares, since a condition has no sign.
Expr violated(const VelocityProblem& at, const Matrix& sizes, const Vector& speeds,
              const std::vector<std::size_t>& rows, Expr part, const Vector& left) {
  std::vector<Expr> conditions;
  for (const std::size_t mu : rows) {
    Expr scale(part.graph(), part.graph().constant(0));
    for (std::size_t j = 0; j < speeds.size(); ++j) scale += pow(sizes[mu][j] * speeds[j], 2);
    conditions.push_back(less(part * scale + left[mu], pow(at.phi[mu], 2)));
  }
  return any(part.graph(), conditions);
}

}  // namespace gaussgen::strategy
