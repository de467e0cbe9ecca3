#include "nonholonomic/constraint_rows.hpp"

namespace gaussgen::nonholonomic {

namespace {

/// Θ_μ: the part of φ̇_μ without second derivatives.
ex drift(const ex& phi, const Chart& chart) {
  GiNaC::exvector terms{phi.diff(chart.time())};
  for (const FullIndex A : chart.all()) terms.push_back(phi.diff(chart[A].y) * chart[A].rate);
  return chart.at_attitude(GiNaC::add(terms));
}

/// Components of grad_v φ_μ along the dual basis э^i.
Row<HeldIndex> dual_components(const Row<FullIndex>& beta, const gauss::Metric& metric, const Chart& chart) {
  Row<HeldIndex> across;
  for (const HeldIndex j : chart.held()) {
    ex sum = beta[chart.full(j)];
    for (const FreeIndex a : chart.free()) {
      for (const FreeIndex b : chart.free()) sum -= beta[chart.full(a)] * metric.g_up[a][b] * metric.G_qx[b][j];
    }
    across.push_back(sum);
  }
  Row<HeldIndex> result(chart.held_count(), ex(0));
  for (const HeldIndex i : chart.held()) {
    for (const HeldIndex j : chart.held()) result[i] += across[j] * metric.E_xx_up[j][i];
  }
  return result;
}

}  // namespace

ConstraintRows constraint_rows(const model::Model& model, const gauss::System& system) {
  const Chart& chart = *system.chart;
  ConstraintRows rows;
  for (const model::VelocityConstraint& constraint : model.constraints) {
    const ex phi = chart(constraint.velocity);
    Row<FullIndex> beta;
    for (const FullIndex A : chart.all()) beta.push_back(chart.at_attitude(phi.diff(chart[A].rate)));
    rows.names.push_back(constraint.name.text);
    rows.phi.push_back(chart.at_attitude(phi));
    rows.beta_drift.push_back(drift(phi, chart));
    rows.b_x.push_back(dual_components(beta, system.metric, chart));
    rows.beta.push_back(std::move(beta));
  }
  return rows;
}

}  // namespace gaussgen::nonholonomic
