#include "rest_equations.hpp"

#include "ir/differentiate.hpp"
#include "ir/substitute.hpp"

namespace gaussgen {

using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;

RestEquations::RestEquations(Mechanics& mechanics) {
  pose(mechanics);
  differentiate(mechanics);
}

void RestEquations::pose(Mechanics& mechanics) {
  const strategy::Dynamics& dynamics = mechanics.dynamics;
  ir::Substitution at_rest(mechanics.graph);
  for (const FreeIndex a : mechanics.symbols.speeds.indices()) {
    const Expr speed = mechanics.kinematics.speeds_at_rest[a];
    at_rest.replace(mechanics.symbols.speeds[a].symbol, speed);
    changes.push_back(ir::partial(speed, mechanics.symbols.time));
  }
  for (std::size_t mu = 0; mu < dynamics.l(); ++mu)
    multipliers.push_back(mechanics.graph.declare(ir::SymbolClass::input, "multiplier_" + std::to_string(mu + 1)));
  for (std::size_t a = 0; a < dynamics.n(); ++a) {
    metric.emplace_back();
    for (const Expr entry : dynamics.g[a]) metric.back().push_back(at_rest(entry));
    Expr force = at_rest(dynamics.f[a]);
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu)
      force += at_rest(dynamics.b[mu][a]) * mechanics.expressions.symbol(multipliers[mu]);
    for (std::size_t b = 0; b < dynamics.n(); ++b) force -= metric[a][b] * changes[b];
    equations.push_back(force);
  }
  for (const auto& row : mechanics.kinematics.constraints) {
    if (row.f) equations.push_back(*row.f);
  }
  for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
    auto& rows = mechanics.kinematics.constraints[ConstraintIndex{mu}].f ? closing : held;
    rows.emplace_back();
    for (const Expr b : dynamics.b[mu]) rows.back().push_back(at_rest(b));
    add_drive(mu, at_rest(mechanics.kinematics.constraints[ConstraintIndex{mu}].phi));
    Expr drift = at_rest(dynamics.b_drift[mu]);
    for (std::size_t b = 0; b < dynamics.n(); ++b) drift += at_rest(dynamics.b[mu][b]) * changes[b];
    add_drive(mu, drift);
  }
}

void RestEquations::add_drive(std::size_t constraint, Expr drive) {
  if (drive.is_zero()) return;
  drives.emplace_back(equations.size(), constraint);
  equations.push_back(drive);
}

void RestEquations::differentiate(Mechanics& mechanics) {
  for (const Expr equation : equations) {
    derivatives.emplace_back();
    for (const ir::SymbolId multiplier : multipliers) derivatives.back().push_back(ir::partial(equation, multiplier));
  }
  std::vector<std::vector<Expr>> along_speeds(equations.size());
  for (const ConfigurationIndex i : mechanics.symbols.configuration.indices()) {
    rates.emplace_back();
    for (const FreeIndex a : mechanics.symbols.speeds.indices())
      rates.back().push_back(
          ir::partial(mechanics.kinematics.configuration_rates[i], mechanics.symbols.speeds[a].symbol));
  }
  for (const FreeIndex a : mechanics.symbols.speeds.indices()) {
    ir::Directional along(mechanics.graph);
    for (const ConfigurationIndex i : mechanics.symbols.configuration.indices())
      along.seed(mechanics.symbols.configuration[i].symbol, rates[i.value][a.value]);
    for (std::size_t row = 0; row < equations.size(); ++row) along_speeds[row].push_back(along(equations[row]));
  }
  for (std::size_t row = 0; row < equations.size(); ++row)
    derivatives[row].insert(derivatives[row].begin(), along_speeds[row].begin(), along_speeds[row].end());
}

}  // namespace gaussgen
