#include "strategy/position_projection.hpp"

#include <algorithm>

#include "ir/substitute.hpp"
#include "strategy/least_change.hpp"
#include "strategy/position_size.hpp"
#include "strategy/quaternions.hpp"
#include "strategy/term_size.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;

namespace {

/// Units of rounding that may be left of an equation, of what it is made of.
const support::Rational k_rounding = 64;

/// Units of rounding that an equation is off by where it holds.
const support::Rational k_of_itself = support::Rational(1) / 2;

}  // namespace

PositionProjection::PositionProjection(const Dynamics& dynamics, std::vector<std::size_t> moving, const Vector& at,
                                       Expr epsilon)
    : dynamics_(dynamics),
      moving_(std::move(moving)),
      dependent_rows_(dependent_rows_over(dynamics, moving_)),
      epsilon_(epsilon),
      singular_(epsilon.graph(), epsilon.graph().constant(0)),
      dependent_(singular_) {
  ir::Substitution put_in(epsilon.graph());
  for (std::size_t i = 0; i < at.size(); ++i)
    put_in.replace(dynamics.kinematics->symbols.configuration[ConfigurationIndex{i}].symbol, at[i]);
  for (const ConstraintIndex mu : dynamics.kinematics->constraints.indices()) {
    if (!dynamics.kinematics->constraints[mu].f) continue;
    rows_.push_back(mu.value);
    const Vector& b = dynamics.b[mu.value];
    if (std::any_of(moving_.begin(), moving_.end(), [&](std::size_t i) { return !put_in(b[i]).is_zero(); }))
      movable_.push_back(mu.value);
  }
}

Vector PositionProjection::zeros(std::size_t count) const {
  return Vector(count, Expr(epsilon_.graph(), epsilon_.graph().constant(0)));
}

Expr PositionProjection::symbol(std::size_t i) const {
  ir::Graph& graph = epsilon_.graph();
  return {graph, graph.use(dynamics_.kinematics->symbols.configuration[ConfigurationIndex{i}].symbol)};
}

Vector PositionProjection::rates_at(const Vector& speeds) const {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  ir::Substitution put_in(epsilon_.graph());
  for (const FreeIndex i : symbols.speeds.indices()) put_in.replace(symbols.speeds[i].symbol, speeds[i.value]);
  Vector values;
  for (const Expr rate : dynamics_.kinematics->configuration_rates) values.push_back(put_in(rate));
  return values;
}

// dq = q̇(u = δ) - q̇(u = 0): what the speeds add, without the part of given motions.
void PositionProjection::displace(const Vector& change, Vector& configuration) const {
  Vector speeds = zeros(dynamics_.n());
  const Vector carried = rates_at(speeds);
  for (std::size_t j = 0; j < moving_.size(); ++j) speeds[moving_[j]] = change[j];
  const Vector moved = rates_at(speeds);
  for (std::size_t i = 0; i < configuration.size(); ++i) {
    configuration[i] = configuration[i] + (moved[i] - carried[i]);
  }
}

Vector PositionProjection::moved(const Vector& change) const {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  Vector configuration;
  for (const ConfigurationIndex i : symbols.configuration.indices()) configuration.push_back(symbol(i.value));
  displace(change, configuration);
  normalise(symbols, configuration);
  return configuration;
}

// Where gradients nearly vanish, as at the change point of a linkage, Newton's method would turn rounding into a displacement that is as
// large as the distance from there, and speeds with it.
Expr PositionProjection::residual(std::size_t mu) const {
  const Expr f = *dynamics_.kinematics->constraints[ConstraintIndex{mu}].f;
  const Expr zero(epsilon_.graph(), epsilon_.graph().constant(0));
  const Expr rounding = k_of_itself * epsilon_ * TermSize(epsilon_.graph())(f);
  return select(at_most(call(ir::Function::abs, f), rounding), zero, f);
}

Vector PositionProjection::step(Steps& steps) {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  const std::string prefix = "move_";
  Change wanted{moving_, movable_, {}, prefix};
  for (const std::size_t mu : movable_) wanted.residuals.push_back(residual(mu));
  steps.begin("smallest displacement in the mass metric that satisfies the linearised equations of positions");
  const Solution found = least_change(dynamics_, wanted, dependent_rows_, epsilon_, steps);
  Vector configuration = moved(found.accelerations);
  for (const ConfigurationIndex i : symbols.configuration.indices()) {
    configuration[i.value] = steps.name(configuration[i.value], prefix + symbols.configuration[i].name);
  }
  singular_ = found.singular_mass_matrix;
  dependent_ = found.dependent_constraints;
  return configuration;
}

// f against rounding of its terms and, to first order, of its coordinates: Newton's method leaves rounding, or much more. Squares, since
// that of coordinates is a sum of squares.
Expr PositionProjection::violated(const Vector& start) const {
  const PositionSize size(dynamics_, start);
  const Vector inertia = inertias(dynamics_);
  std::vector<ir::NodeId> weighted;
  for (const FreeIndex i : dynamics_.kinematics->symbols.speeds.indices())
    weighted.push_back((inertia[i.value] * size.of_speed(i)).id());
  const Expr size_of_all(epsilon_.graph(), epsilon_.graph().sum(weighted));
  TermSize size_of_terms(epsilon_.graph());
  std::vector<Expr> conditions;
  for (const std::size_t mu : rows_) {
    const Expr f = *dynamics_.kinematics->constraints[ConstraintIndex{mu}].f;
    const Expr left = left_by_all(dynamics_.b[mu], inertia, size_of_all, epsilon_);
    const Expr rounded = pow(k_rounding * epsilon_, 2) * (size.of_row(mu) + pow(size_of_terms(f), 2));
    conditions.push_back(less(rounded + left, pow(f, 2)));
  }
  return any(epsilon_.graph(), conditions);
}

}  // namespace gaussgen::strategy
