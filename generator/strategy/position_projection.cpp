#include "strategy/position_projection.hpp"

#include <algorithm>

#include "ir/differentiate.hpp"
#include "ir/rounded.hpp"
#include "strategy/accelerations.hpp"
#include "strategy/quaternions.hpp"
#include "strategy/state_values.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;

PositionProjection::PositionProjection(const Dynamics& dynamics, std::vector<std::size_t> moving,
                                       std::optional<Expr> time, Expr epsilon)
    : dynamics_(dynamics),
      moving_(std::move(moving)),
      dependent_rows_(dependent_rows_over(dynamics, moving_)),
      time_(time),
      epsilon_(epsilon),
      singular_(epsilon.graph(), epsilon.graph().constant(0)),
      dependent_(singular_) {
  for (const ConstraintIndex mu : dynamics.kinematics->constraints.indices()) {
    if (dynamics.kinematics->constraints[mu].f) rows_.push_back(mu.value);
  }
}

Vector PositionProjection::zeros(std::size_t count) const {
  return Vector(count, Expr(epsilon_.graph(), epsilon_.graph().constant(0)));
}

Vector PositionProjection::at(const Vector& expressions, const Vector& configuration, const Vector& speeds) const {
  ir::Substitution put_in = state_values(dynamics_.kinematics->symbols, time_, configuration, speeds);
  Vector values;
  for (const Expr expression : expressions) values.push_back(put_in(expression));
  return values;
}

Dynamics PositionProjection::problem_at(const Vector& configuration, const std::string& prefix) const {
  const Vector rest = zeros(dynamics_.n());
  const auto part = [&](const Vector& row) {
    Vector chosen;
    for (const std::size_t i : moving_) chosen.push_back(row[i]);
    return at(chosen, configuration, rest);
  };
  Dynamics problem;
  problem.names = {prefix, "move", "push"};
  problem.dependent_rows = dependent_rows_;
  for (const std::size_t i : moving_) {
    problem.labels.push_back(dynamics_.labels[i]);
    problem.g.push_back(part(dynamics_.g[i]));
  }
  problem.f = zeros(moving_.size());
  for (const std::size_t mu : rows_) {
    const Vector row = part(dynamics_.b[mu]);
    if (std::all_of(row.begin(), row.end(), [](Expr e) { return e.is_zero(); })) continue;
    problem.constraints.push_back(dynamics_.constraints[mu]);
    problem.b.push_back(row);
    const Expr f = *dynamics_.kinematics->constraints[ConstraintIndex{mu}].f;
    problem.b_drift.push_back(without_rounding(at({f}, configuration, rest)[0]));
  }
  return problem;
}

// dq = q̇(u = δ) - q̇(u = 0): what the speeds add, without the part of given motions.
void PositionProjection::displace(const Vector& change, Vector& configuration) const {
  Vector speeds = zeros(dynamics_.n());
  const Vector& rates = dynamics_.kinematics->configuration_rates.values();
  const Vector carried = at(rates, configuration, speeds);
  for (std::size_t j = 0; j < moving_.size(); ++j) speeds[moving_[j]] = change[j];
  const Vector moved = at(rates, configuration, speeds);
  for (std::size_t i = 0; i < configuration.size(); ++i) {
    configuration[i] = rounded(configuration[i] + (moved[i] - carried[i]));
  }
}

void PositionProjection::run(int count, Vector& configuration, Steps& steps) {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  for (int step = 0; step < count; ++step) {
    const std::string prefix = "move" + std::to_string(step + 1) + "_";
    const Dynamics problem = problem_at(configuration, prefix);
    if (problem.l() == 0) return;
    Steps inner_steps;
    const Solution change = solve_with_multipliers(problem, epsilon_, inner_steps);
    steps.begin("smallest displacement in the mass metric that satisfies the linearised equations of positions");
    for (const Step& inner_step : inner_steps.all()) steps.append(inner_step.values);
    displace(change.accelerations, configuration);
    normalise(symbols, configuration);
    for (const ConfigurationIndex i : symbols.configuration.indices()) {
      configuration[i.value] = steps.name(configuration[i.value], prefix + symbols.configuration[i].name);
    }
    singular_ = any(epsilon_.graph(), {singular_, change.singular_mass_matrix});
    dependent_ = any(epsilon_.graph(), {dependent_, change.dependent_constraints});
  }
}

/// ∂f/∂q of a coordinate whose rate is no speed, times the size of q; squares.
Expr PositionProjection::along_coordinate(std::size_t mu, std::size_t i, const Vector& start,
                                          const Vector& configuration) const {
  const kinematics::ConfigurationVariable& q = dynamics_.kinematics->symbols.configuration[ConfigurationIndex{i}];
  const Expr gradient = ir::partial(*dynamics_.kinematics->constraints[ConstraintIndex{mu}].f, q.symbol);
  if (gradient.is_zero()) return zeros(1)[0];
  const Expr size = pow(start[i], 2) + pow(configuration[i], 2);
  const Expr one(epsilon_.graph(), epsilon_.graph().constant(q.unit == "m" ? 0 : 1));
  return pow(at({gradient}, configuration, zeros(dynamics_.n()))[0], 2) * (size + one);
}

// Angles count as 1 besides their size, since they may have gone anywhere.
Expr PositionProjection::size_of(FreeIndex i, const Vector& start, const Vector& configuration) const {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  Expr size(epsilon_.graph(), epsilon_.graph().constant(symbols.speeds[i].is_of_length() ? 0 : 1));
  if (i.value < symbols.plain_count() && !symbols.speeds[i].replaces_rate) {
    size += pow(start[i.value], 2) + pow(configuration[i.value], 2);
  }
  return size;
}

// What rounding of all coordinates, weighed by mass, may leave of f, b its row: a height of 0 beside them is as good as 1e-50.
Expr PositionProjection::left_by_all(const Vector& b, const Vector& inertia, Expr size_of_all) const {
  const Expr zero = zeros(1)[0];
  Expr squares = zero, weighted = zero;
  for (std::size_t i = 0; i < b.size(); ++i) {
    squares += pow(b[i], 2);
    weighted += pow(b[i], 2) * inertia[i];
  }
  const Expr left = support::Rational(10'000) * pow(epsilon_, 2) * size_of_all * pow(squares, 2) / weighted;
  return weighted.is_zero() ? zero : select(less(zero, weighted), left, zero);
}

// f against what it is made of to first order, with half of the digits: Newton's method leaves rounding, or much more. Squares, since
// a condition has no sign.
Expr PositionProjection::violated(const Vector& start, const Vector& configuration) const {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  const Vector rest = zeros(dynamics_.n());
  Vector inertia;
  for (std::size_t i = 0; i < dynamics_.n(); ++i) inertia.push_back(dynamics_.g[i][i]);
  inertia = at(inertia, configuration, rest);
  Expr size_of_all = zeros(1)[0];
  for (const FreeIndex i : symbols.speeds.indices()) {
    size_of_all += inertia[i.value] * size_of(i, start, configuration);
  }
  std::vector<Expr> conditions;
  for (const std::size_t mu : rows_) {
    const Expr f =
        without_rounding(at({*dynamics_.kinematics->constraints[ConstraintIndex{mu}].f}, configuration, rest)[0]);
    const Vector b = at(dynamics_.b[mu], configuration, rest);
    Expr scale = zeros(1)[0];
    for (const FreeIndex i : symbols.speeds.indices()) {
      if (!b[i.value].is_zero()) scale += pow(b[i.value], 2) * size_of(i, start, configuration);
    }
    for (const FreeIndex i : symbols.speeds.indices()) {
      if (symbols.speeds[i].replaces_rate) scale += along_coordinate(mu, i.value, start, configuration);
    }
    conditions.push_back(less(epsilon_ * scale + left_by_all(b, inertia, size_of_all), pow(f, 2)));
  }
  return any(epsilon_.graph(), conditions);
}

}  // namespace gaussgen::strategy
