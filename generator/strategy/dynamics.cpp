#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;
using kinematics::FullIndex;
using kinematics::HeldIndex;

namespace {

Matrix metric(const kinematics::Symbols& symbols, const kinematics::Covariant& covariant, Steps& steps) {
  steps.begin("metric g_ab (1.10); held coordinates enter only through f");
  Matrix g;
  for (const FreeIndex i : symbols.speeds.indices()) {
    Vector row;
    for (const FreeIndex j : symbols.speeds.indices()) {
      const Expr entry = covariant.G[symbols.full(i)][symbols.full(j)];
      const std::string name = "G_" + symbols.speeds[j].label + "_" + symbols.speeds[i].label;
      row.push_back(j.value <= i.value ? steps.name(entry, name) : entry);
    }
    g.push_back(row);
  }
  return g;
}

Vector force(const kinematics::Kinematics& kinematics, const kinematics::Covariant& covariant, Steps& steps) {
  const kinematics::Symbols& symbols = kinematics.symbols;
  steps.begin("f = Q - bias: active forces less the velocity-squared part of A (theory.md, section 4)");
  Vector result;
  for (const FreeIndex i : symbols.speeds.indices()) {
    const FullIndex a = symbols.full(i);
    const std::string& label = symbols.speeds[i].label;
    const Expr bias = steps.name(covariant.bias[a], "bias_" + label);
    Expr f = covariant.Q[a] - bias;
    for (const HeldIndex j : symbols.held.indices()) {
      f -= covariant.G[a][symbols.full(j)] * kinematics.held_acceleration[j];
    }
    result.push_back(steps.name(f, "f_" + label));
  }
  return result;
}

void add_rows(const kinematics::Kinematics& kinematics, Dynamics& result, Steps& steps) {
  const kinematics::Symbols& symbols = kinematics.symbols;
  for (const ConstraintIndex mu : kinematics.constraints.indices()) {
    const kinematics::ConstraintRow& row = kinematics.constraints[mu];
    steps.begin(row.name + ", differentiated once: beta du/dt + drift = 0 (theory.md, section 3)", row.name);
    result.constraints.push_back(row.name);
    Vector b;
    for (const FreeIndex i : symbols.speeds.indices()) {
      b.push_back(steps.name(row.beta[symbols.full(i)], "beta_" + row.name + "_" + result.labels[i.value]));
    }
    Expr drift = row.beta_drift;
    for (const HeldIndex j : symbols.held.indices()) {
      drift += row.beta[symbols.full(j)] * kinematics.held_acceleration[j];
    }
    result.b.push_back(b);
    result.b_drift.push_back(steps.name(drift, "drift_" + row.name));
  }
}

}  // namespace

Vector inertias(const Dynamics& dynamics) {
  if (dynamics.inertias_of_links) return dynamics.inertias_of_links();
  Vector result;
  for (std::size_t i = 0; i < dynamics.n(); ++i) result.push_back(dynamics.g[i][i]);
  return result;
}

Matrix g_above_b(const Dynamics& dynamics) {
  Matrix rows = dynamics.g;
  rows.insert(rows.end(), dynamics.b.begin(), dynamics.b.end());
  return rows;
}

DependentRows dependent_rows_over(const Dynamics& dynamics, const std::vector<std::size_t>& speeds) {
  if (dynamics.l() == 0) return [](const Matrix&) { return std::vector<std::size_t>(); };
  // Once, and only where somebody asks: the block has as many entries as there are pairs of speeds.
  const support::Lazy<std::vector<std::size_t>> rows([&dynamics, speeds] {
    Matrix block;
    for (const std::size_t i : speeds) {
      block.emplace_back();
      for (const std::size_t j : speeds) block.back().push_back(dynamics.g[i][j]);
    }
    return dynamics.dependent_rows(block);
  });
  return [rows](const Matrix&) { return *rows; };
}

Dynamics build_dynamics(const kinematics::Kinematics& kinematics, const support::Lazy<kinematics::Covariant>& covariant,
                        DependentRows dependent_rows, Steps& steps, Steps& metric_steps) {
  Dynamics result;
  result.dependent_rows = std::move(dependent_rows);
  result.kinematics = &kinematics;
  result.covariant = &covariant;
  for (const kinematics::Speed& speed : kinematics.symbols.speeds) result.labels.push_back(speed.label);
  result.g = support::LazyList<Matrix>(
      [&kinematics, &covariant, &metric_steps] { return metric(kinematics.symbols, *covariant, metric_steps); });
  result.f = support::LazyList<Vector>(
      [&kinematics, &covariant, &metric_steps] { return force(kinematics, *covariant, metric_steps); });
  add_rows(kinematics, result, steps);
  return result;
}

}  // namespace gaussgen::strategy
