#include "strategy/accelerations.hpp"

#include "ir/cost.hpp"
#include "strategy/inner.hpp"
#include "strategy/margins.hpp"
#include "support/suggest.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

std::string acceleration_name(const Dynamics& dynamics) { return dynamics.names.prefix + dynamics.names.acceleration; }
std::string multiplier_name(const Dynamics& dynamics) { return dynamics.names.prefix + dynamics.names.multiplier; }

std::vector<std::string> labels_of(const Dynamics& dynamics, const std::vector<std::size_t>& which) {
  std::vector<std::string> labels;
  for (const std::size_t i : which) labels.push_back(dynamics.labels[i]);
  return labels;
}

/// C with a = C a_p + d: rows of c_dep for dependent speeds, unit rows for the others.
struct Embedding {
  Matrix C;
  Vector d;
};

Embedding embedding(const Dynamics& dynamics, const Elimination& elimination) {
  ir::Graph& graph = dynamics.g[0][0].graph();
  const Expr zero(graph, graph.constant(0));
  const Expr one(graph, graph.constant(1));
  const std::size_t free_count = elimination.independent.size();
  Embedding result{Matrix(dynamics.n(), Vector(free_count, zero)), Vector(dynamics.n(), zero)};
  for (std::size_t p = 0; p < free_count; ++p) result.C[elimination.independent[p]][p] = one;
  for (std::size_t i = 0; i < elimination.dependent.size(); ++i) {
    result.C[elimination.dependent[i]] = elimination.c_dep[i];
    result.d[elimination.dependent[i]] = elimination.drift[i];
  }
  return result;
}

Vector column(const Matrix& matrix, std::size_t j) {
  Vector result;
  for (const Vector& row : matrix) result.push_back(row[j]);
  return result;
}

Matrix reduced_metric(const Dynamics& dynamics, const Embedding& embed, const std::vector<std::string>& labels,
                      Steps& steps) {
  ir::Graph& graph = dynamics.g[0][0].graph();
  const std::size_t count = labels.size();
  const Expr zero(graph, graph.constant(0));
  Matrix reduced(count, Vector(count, zero));
  steps.begin("reduced metric C^T g C of the independent accelerations");
  for (std::size_t q = 0; q < count; ++q) {
    const Vector C_q = column(embed.C, q);
    Vector g_C;
    for (const Vector& row : dynamics.g) g_C.push_back(inner(graph, row, C_q));
    for (std::size_t p = 0; p <= q; ++p) {
      const Expr entry = inner(graph, column(embed.C, p), g_C);
      reduced[p][q] = steps.name(entry, dynamics.names.prefix + "M_" + labels[p] + "_" + labels[q]);
      reduced[q][p] = reduced[p][q];
    }
  }
  return reduced;
}

Vector reduced_force(const Dynamics& dynamics, const Embedding& embed, const std::vector<std::string>& labels,
                     Steps& steps) {
  ir::Graph& graph = dynamics.g[0][0].graph();
  Vector force;
  for (std::size_t i = 0; i < dynamics.n(); ++i) force.push_back(dynamics.f[i] - inner(graph, dynamics.g[i], embed.d));
  steps.begin("right-hand side of (3.7): C^T (f - g drift)");
  Vector reduced;
  for (std::size_t p = 0; p < labels.size(); ++p) {
    reduced.push_back(steps.name(inner(graph, column(embed.C, p), force), dynamics.names.prefix + "F_" + labels[p]));
  }
  return reduced;
}

// A_μ - Q_μ, over the dependent accelerations as values or written out, whichever is cheaper: written out, what cancels
// identically vanishes (the sphere's tangential friction), where values would leave their rounding.
Expr excess(const Dynamics& dynamics, std::size_t mu, const Vector& a, const Vector& written_out) {
  ir::Graph& graph = dynamics.g[0][0].graph();
  const Expr by_value = inner(graph, dynamics.g[mu], a) - dynamics.f[mu];
  const Expr in_full = inner(graph, dynamics.g[mu], written_out) - dynamics.f[mu];
  return ir::operations(graph, {in_full.id()}) < ir::operations(graph, {by_value.id()}) ? in_full : by_value;
}

// b_ρμ λ_ρ = A_μ - Q_μ for the dependent μ: the transposed system, eliminated with the same (safe) pivots.
Vector multipliers_of(const Dynamics& dynamics, const Elimination& elimination, const Vector& a,
                      const Vector& written_out, Steps& steps) {
  ir::Graph& graph = dynamics.g[0][0].graph();
  const std::size_t l = dynamics.l();
  Matrix system;
  Vector residual;
  steps.begin("multipliers: A_m - Q_m = lambda_r b_r_m over the dependent speeds (3.4)");
  for (std::size_t i = 0; i < l; ++i) {
    const std::size_t mu = elimination.dependent[i];
    Vector row;
    for (std::size_t j = 0; j < l; ++j) row.push_back(dynamics.b[elimination.rows[j]][mu]);
    system.push_back(row);
    residual.push_back(
        steps.name(excess(dynamics, mu, a, written_out), dynamics.names.prefix + "excess_" + dynamics.labels[mu]));
  }
  for (std::size_t k = 0; k < l; ++k) {
    const Expr reciprocal = pow(system[k][k], -1);
    for (std::size_t i = k + 1; i < l; ++i) {
      if (system[i][k].is_zero()) continue;
      const Expr factor = system[i][k] * reciprocal;
      for (std::size_t j = k + 1; j < l; ++j) system[i][j] = system[i][j] - factor * system[k][j];
      residual[i] = residual[i] - factor * residual[k];
    }
  }
  const Expr zero(graph, graph.constant(0));
  Vector lambda(l, zero);
  Vector in_order(l, zero);
  for (std::size_t k = l; k-- > 0;) {
    Expr value = residual[k];
    for (std::size_t j = k + 1; j < l; ++j) value -= system[k][j] * in_order[j];
    const std::size_t row = elimination.rows[k];
    in_order[k] =
        steps.name(value * pow(system[k][k], -1), multiplier_name(dynamics) + "_" + dynamics.constraints[row]);
    lambda[row] = in_order[k];
  }
  return lambda;
}

// Pivots of either sign: |p| <= 0. And where parameters change after the choice was made, half of the digits have to be left beside what
// the dependent ones add.
Expr vanished(const Elimination& elimination, Expr epsilon) {
  ir::Graph& graph = epsilon.graph();
  const Expr zero(graph, graph.constant(0));
  Margins margins(graph);
  for (const Expr pivot : elimination.pivots) margins.require(select(less(pivot, zero), -pivot, pivot), zero);
  for (const Addition& addition : elimination.additions) {
    if (!addition.is_known()) margins.require(addition.before, addition.least(epsilon));
  }
  return margins.violated("least_pivot");
}

}  // namespace

Solution solve_unconstrained(const Dynamics& dynamics, Expr epsilon, Steps& steps) {
  ir::Graph& graph = epsilon.graph();
  const Expr never(graph, graph.constant(0));
  if (dynamics.n() == 0)
    return {{}, {}, never, never, "no free coordinates: reactions are those of the held motion", {}, {}, {}};
  steps.begin("g = L D L^T");
  const Ldl ldl(dynamics.g, dynamics.labels, dynamics.names.prefix + "g", epsilon, steps);
  steps.begin("accelerations from dZ/da = 0 (1.15)");
  return {ldl.solve(dynamics.f, acceleration_name(dynamics), steps),
          {},
          ldl.singular(),
          never,
          "unrolled L D L^T of the metric; no nonholonomic constraints",
          ldl.vanishing(),
          {},
          {}};
}

Solution solve_by_elimination(const Dynamics& dynamics, const Elimination& elimination, Expr epsilon, Steps& steps) {
  ir::Graph& graph = epsilon.graph();
  const Expr never(graph, graph.constant(0));
  const Embedding embed = embedding(dynamics, elimination);
  const std::vector<std::string> labels = labels_of(dynamics, elimination.independent);
  Vector a = embed.d;
  Vector written_out = embed.d;
  Expr breakdown = never;
  std::vector<std::string> undetermined;
  if (!labels.empty()) {
    const Matrix M = reduced_metric(dynamics, embed, labels, steps);
    const Vector F = reduced_force(dynamics, embed, labels, steps);
    steps.begin("C^T g C = L D L^T");
    const Ldl ldl(M, labels, dynamics.names.prefix + "M", epsilon, steps);
    breakdown = ldl.singular();
    undetermined = ldl.vanishing();
    steps.begin("independent accelerations (3.7)");
    const Vector a_p = ldl.solve(F, acceleration_name(dynamics), steps);
    for (std::size_t p = 0; p < labels.size(); ++p) a[elimination.independent[p]] = a_p[p];
    steps.begin("dependent accelerations (3.6)");
    for (std::size_t i = 0; i < elimination.dependent.size(); ++i) {
      const std::size_t mu = elimination.dependent[i];
      written_out[mu] = inner(graph, elimination.c_dep[i], a_p) + elimination.drift[i];
      a[mu] = steps.name(written_out[mu], acceleration_name(dynamics) + "_" + dynamics.labels[mu]);
    }
    for (std::size_t p = 0; p < labels.size(); ++p) written_out[elimination.independent[p]] = a_p[p];
  }
  const Vector lambda = multipliers_of(dynamics, elimination, a, written_out, steps);
  return {a,
          lambda,
          breakdown,
          vanished(elimination, epsilon),
          "elimination (3.6)-(3.7) with dependent speeds " +
              support::joined(labels_of(dynamics, elimination.dependent)) +
              "; safe because det b over them depends on parameters alone",
          undetermined,
          {},
          elimination.dependent};
}

}  // namespace gaussgen::strategy
