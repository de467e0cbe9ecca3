#include "nonholonomic/elimination.hpp"

namespace gaussgen::nonholonomic {

namespace {

Table<DependentIndex, ConstraintIndex> inverse_of_b(const ConstraintRows& rows, const Partition& partition,
                                                    gauss::System& system) {
  const Chart& chart = *system.chart;
  symbolic::Matrix b;
  std::vector<std::string> labels;
  for (const ConstraintIndex mu : rows.indices()) {
    std::vector<ex> row;
    for (const FreeIndex a : partition.dependent) row.push_back(rows.beta[mu][chart.full(a)]);
    b.push_back(std::move(row));
  }
  for (const FreeIndex a : partition.dependent) labels.push_back(chart[a].label);
  Table<DependentIndex, ConstraintIndex> result;
  for (const std::vector<ex>& row : system.bindings.invert("b_inv", labels, rows.names, b, false)) {
    result.push_back(Row<ConstraintIndex>(row));
  }
  return result;
}

/// -(b^-1)^{μρ} v_ρ
ex eliminated(const Row<ConstraintIndex>& b_inv, const Row<ConstraintIndex>& v) {
  ex sum = 0;
  for (const ConstraintIndex rho : v.indices()) sum -= b_inv[rho] * v[rho];
  return sum;
}

template <class Index, class Entry>
Row<ConstraintIndex> column(const Table<ConstraintIndex, Index>& table, Entry entry) {
  Row<ConstraintIndex> result;
  for (const ConstraintIndex rho : table.indices()) result.push_back(entry(table[rho]));
  return result;
}

/// β_ρi ẍ^i + Θ_ρ
Row<ConstraintIndex> imposed(const ConstraintRows& rows, const Chart& chart) {
  Row<ConstraintIndex> result = rows.beta_drift;
  for (const ConstraintIndex rho : rows.indices()) {
    for (const HeldIndex i : chart.held()) result[rho] += rows.beta[rho][chart.full(i)] * chart[i].acceleration;
  }
  return result;
}

}  // namespace

Elimination elimination(const ConstraintRows& rows, const Partition& partition, gauss::System& system) {
  const Chart& chart = *system.chart;
  Elimination result;
  result.b_inv = inverse_of_b(rows, partition, system);
  const Row<ConstraintIndex> known = imposed(rows, chart);
  for (const DependentIndex mu : partition.dependent.indices()) {
    const Row<ConstraintIndex>& b_inv = result.b_inv[mu];
    const std::string& label = chart[partition.dependent[mu]].label;
    Row<IndependentIndex> c;
    for (const FreeIndex p : partition.independent) {
      const ex value = eliminated(b_inv, column(rows.beta, [&](const auto& row) { return row[chart.full(p)]; }));
      c.push_back(system.bindings.define("c_" + label + "_" + chart[p].label, value));
    }
    Row<HeldIndex> b_up;
    for (const HeldIndex i : chart.held()) {
      b_up.push_back(eliminated(b_inv, column(rows.b_x, [&](const auto& row) { return row[i]; })));
    }
    result.c_dep.push_back(std::move(c));
    result.b_x_up.push_back(std::move(b_up));
    result.drift.push_back(system.bindings.define("drift_" + label, eliminated(b_inv, known)));
  }
  return result;
}

}  // namespace gaussgen::nonholonomic
