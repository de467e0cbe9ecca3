#include "gauss/compulsion.hpp"

#include "symbolic/rational.hpp"

namespace gaussgen::gauss {

namespace {

Row<FreeIndex> raised(const Row<FullIndex>& v, const Metric& metric, const Chart& chart) {
  Row<FreeIndex> v_up(chart.free_count(), ex(0));
  for (const FreeIndex a : chart.free()) {
    for (const FreeIndex b : chart.free()) v_up[a] += metric.g_up[a][b] * v[chart.full(b)];
  }
  return v_up;
}

/// Coefficients of the dual э^i of a vector with covariant components v_A and v^α = g^αβ v_β.
Row<HeldIndex> dual_coefficients(const Row<FullIndex>& v, const Row<FreeIndex>& v_up, const Metric& metric,
                                 const Chart& chart) {
  Row<HeldIndex> result;
  for (const HeldIndex i : chart.held()) {
    ex sum = v[chart.full(i)];
    for (const FreeIndex a : chart.free()) sum -= metric.G_qx[a][i] * v_up[a];
    result.push_back(sum);
  }
  return result;
}

/// With a double underscore, which no name of a model has.
template <class Index>
Row<Index> variables(const std::string& prefix, const std::vector<Index>& indices, const Chart& chart) {
  Row<Index> result;
  for (const Index i : indices) result.push_back(GiNaC::realsymbol(prefix + chart[i].label));
  return result;
}

template <class Index>
ex square(const Row<Index>& v, const Table<Index, Index>& metric) {
  ex sum = 0;
  for (const Index i : v.indices()) {
    for (const Index j : v.indices()) sum += metric[i][j] * v[i] * v[j];
  }
  return sum;
}

template <class Index>
Row<Index> difference(const Row<Index>& a, const Row<Index>& b) {
  Row<Index> result;
  for (const Index i : a.indices()) result.push_back(a[i] - b[i]);
  return result;
}

template <class Index>
Row<Index> gradient(const ex& f, const Row<Index>& variables) {
  Row<Index> result;
  for (const Index i : variables.indices()) result.push_back(f.diff(GiNaC::ex_to<GiNaC::symbol>(variables[i])));
  return result;
}

}  // namespace

InvariantAccelerations invariant_accelerations(const Connection& connection, const Metric& metric,
                                               const Row<FullIndex>& Q, const Chart& chart) {
  InvariantAccelerations result;
  for (const FullIndex A : chart.all()) {
    ex sum = connection.bias[A];
    for (const FullIndex B : chart.all()) sum += metric.G[A][B] * chart[B].acceleration;
    result.A.push_back(sum);
  }
  result.a_q_up = raised(result.A, metric, chart);
  result.a_x = dual_coefficients(result.A, result.a_q_up, metric, chart);
  result.Q_q_up = raised(Q, metric, chart);
  result.F_x = dual_coefficients(Q, result.Q_q_up, metric, chart);
  return result;
}

Compulsion compulsion(const InvariantAccelerations& invariant, const Metric& metric, const Chart& chart) {
  const ex half = symbolic::number(support::Rational(1) / 2);
  Compulsion result;
  result.a_q_up = variables("a__up_", chart.free(), chart);
  result.a_x = variables("a__", chart.held(), chart);
  result.R_x = variables("R__", chart.held(), chart);
  const Row<FreeIndex> along = difference(result.a_q_up, invariant.Q_q_up);
  const Row<HeldIndex> across = difference(result.a_x, invariant.F_x);
  result.Z = half * (square(along, metric.G_qq) + square(difference(across, result.R_x), metric.E_xx_up));
  result.Z_w = half * (square(along, metric.G_qq) + square(across, metric.E_xx_up));
  result.dZ_da_q = gradient(result.Z, result.a_q_up);
  result.dZ_da_x = gradient(result.Z, result.a_x);
  result.dZ_w_da_x = gradient(result.Z_w, result.a_x);
  return result;
}

ex at_motion(const ex& f, const Compulsion& compulsion, const InvariantAccelerations& invariant) {
  GiNaC::exmap values;
  for (const FreeIndex a : compulsion.a_q_up.indices()) values[compulsion.a_q_up[a]] = invariant.a_q_up[a];
  for (const HeldIndex i : compulsion.a_x.indices()) values[compulsion.a_x[i]] = invariant.a_x[i];
  return f.subs(values, GiNaC::subs_options::no_pattern);
}

}  // namespace gaussgen::gauss
