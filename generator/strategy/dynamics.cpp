#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;
using kinematics::FullIndex;
using kinematics::HeldIndex;

namespace {

void add_metric(const kinematics::Symbols& symbols, Dynamics& result, Steps& steps) {
  steps.begin("metric g_ab (1.10); held coordinates enter only through f");
  for (const FreeIndex i : symbols.speeds.indices()) {
    Vector row;
    for (const FreeIndex j : symbols.speeds.indices()) {
      const Expr entry = result.covariant->G[symbols.full(i)][symbols.full(j)];
      row.push_back(j.value <= i.value ? steps.name(entry, "G_" + result.labels[j.value] + "_" + result.labels[i.value])
                                       : entry);
    }
    result.g.push_back(row);
  }
}

void add_force(const kinematics::Kinematics& kinematics, Dynamics& result, Steps& steps) {
  const kinematics::Symbols& symbols = kinematics.symbols;
  steps.begin("f = Q - bias: active forces less the velocity-squared part of A (theory.md, section 4)");
  for (const FreeIndex i : symbols.speeds.indices()) {
    const FullIndex a = symbols.full(i);
    const Expr bias = steps.name(result.covariant->bias[a], "bias_" + result.labels[i.value]);
    Expr f = result.covariant->Q[a] - bias;
    for (const HeldIndex j : symbols.held.indices()) {
      f -= result.covariant->G[a][symbols.full(j)] * kinematics.held_acceleration[j];
    }
    result.f.push_back(steps.name(f, "f_" + result.labels[i.value]));
  }
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

Matrix g_above_b(const Dynamics& dynamics) {
  Matrix rows = dynamics.g;
  rows.insert(rows.end(), dynamics.b.begin(), dynamics.b.end());
  return rows;
}

DependentRows dependent_rows_over(const Dynamics& dynamics, const std::vector<std::size_t>& speeds) {
  if (dynamics.l() == 0) return [](const Matrix&) { return std::vector<std::size_t>(); };
  Matrix block;
  for (const std::size_t i : speeds) {
    block.emplace_back();
    for (const std::size_t j : speeds) block.back().push_back(dynamics.g[i][j]);
  }
  return [rows = dynamics.dependent_rows(block)](const Matrix&) { return rows; };
}

Dynamics build_dynamics(const kinematics::Kinematics& kinematics, const kinematics::Covariant& covariant,
                        DependentRows dependent_rows, Steps& steps) {
  Dynamics result;
  result.dependent_rows = std::move(dependent_rows);
  result.kinematics = &kinematics;
  result.covariant = &covariant;
  for (const kinematics::Speed& speed : kinematics.symbols.speeds) result.labels.push_back(speed.label);
  add_metric(kinematics.symbols, result, steps);
  add_force(kinematics, result, steps);
  add_rows(kinematics, result, steps);
  return result;
}

}  // namespace gaussgen::strategy
