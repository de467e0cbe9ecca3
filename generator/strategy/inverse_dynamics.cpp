#include "strategy/inverse_dynamics.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "ir/differentiate.hpp"
#include "ir/substitute.hpp"
#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

/// ∂f/∂(input)
Vector influence(const Dynamics& dynamics, ir::SymbolId input) {
  Vector column;
  for (const Expr f : dynamics.f) column.push_back(ir::partial(f, input));
  return column;
}

bool is_zero(const Vector& column) {
  return std::all_of(column.begin(), column.end(), [](Expr entry) { return entry.is_zero(); });
}

bool is_linear(const std::vector<Vector>& columns, const std::vector<ir::SymbolId>& inputs) {
  return std::all_of(columns.begin(), columns.end(), [&](const Vector& column) {
    return std::all_of(inputs.begin(), inputs.end(), [&](ir::SymbolId input) {
      return std::all_of(column.begin(), column.end(), [&](Expr entry) { return ir::partial(entry, input).is_zero(); });
    });
  });
}

Expr product(const Vector& row, const Vector& column) {
  Expr sum = row[0] * column[0];
  for (std::size_t i = 1; i < row.size(); ++i) sum += row[i] * column[i];
  return sum;
}

}  // namespace

Vector missing_forces(const Dynamics& dynamics, const Vector& wanted, const Vector& multipliers, Steps& steps) {
  steps.begin("g a - f less what the constraints do: what is missing along each speed");
  Vector forces;
  for (std::size_t i = 0; i < dynamics.n(); ++i) {
    Expr force = product(dynamics.g[i], wanted) - dynamics.f[i];
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu) force -= dynamics.b[mu][i] * multipliers[mu];
    forces.push_back(steps.name(force, "missing_" + dynamics.labels[i]));
  }
  return forces;
}

std::optional<Drives> drives(const Dynamics& dynamics, const Vector& wanted, const std::vector<std::size_t>& sought,
                             Expr epsilon, Steps& steps) {
  std::vector<ir::SymbolId> inputs;
  for (const std::size_t k : sought) inputs.push_back(dynamics.kinematics->symbols.inputs[k]);
  const Expr never(epsilon.graph(), epsilon.graph().constant(0));
  Drives result{{}, {}, {}, never, never};
  std::vector<Vector> columns;
  ir::Substitution without_inputs(epsilon.graph());
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    Vector column = influence(dynamics, inputs[k]);
    without_inputs.replace(inputs[k], never);
    if (is_zero(column)) continue;
    columns.push_back(std::move(column));
    result.inputs.push_back(sought[k]);
  }
  if (columns.empty() || !is_linear(columns, inputs)) return std::nullopt;

  Dynamics problem = dynamics;
  problem.names = {"", "driven", "drive"};
  problem.constraints.clear();
  problem.b.clear();
  problem.b_drift.clear();
  for (Expr& f : problem.f) f = without_inputs(f);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    problem.constraints.push_back("input" + std::to_string(k + 1));
    problem.b.push_back(columns[k]);
    problem.b_drift.push_back(-product(columns[k], wanted));
  }
  problem.constraints.insert(problem.constraints.end(), dynamics.constraints.begin(), dynamics.constraints.end());
  problem.b.insert(problem.b.end(), dynamics.b.begin(), dynamics.b.end());
  problem.b_drift.insert(problem.b_drift.end(), dynamics.b_drift.begin(), dynamics.b_drift.end());

  Steps inner;
  const Solution solution = solve_with_multipliers(problem, epsilon, inner);
  steps.begin("inputs as multipliers of servo constraints: their accelerations are the wanted ones");
  for (const Step& step : inner.all()) steps.append(step.values);
  result.values.assign(solution.multipliers.begin(),
                       solution.multipliers.begin() + static_cast<std::ptrdiff_t>(columns.size()));
  result.accelerations = solution.accelerations;
  result.singular_mass_matrix = solution.singular_mass_matrix;
  result.dependent_constraints = solution.dependent_constraints;
  return result;
}

}  // namespace gaussgen::strategy
