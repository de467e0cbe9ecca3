// Three ways to the same accelerations, multipliers and reactions: the emitted route (Jacobians and h on the graph), the
// multiplier form, and the paper's route (Christoffel symbols in GiNaC). They share the expression parser and nothing of the
// mechanics.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch_shim.hpp"
#include "models.hpp"
#include "paper.hpp"

namespace {

using agreement::State;
using gaussgen::Mechanics;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;

constexpr int k_states = 1000;
constexpr double k_largest_condition = 1e8;
constexpr double k_eps = 2.220446049250313e-16;

struct Answer {
  Eigen::VectorXd a, lambda, R;
};

Eigen::VectorXd values(Evaluator<double>& evaluator, const std::vector<gaussgen::ir::NodeId>& nodes) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto value = evaluator(nodes[i]);
    result[static_cast<Eigen::Index>(i)] = value ? *value : std::nan("");
  }
  return result;
}

std::vector<gaussgen::ir::NodeId> nodes(const gaussgen::strategy::Vector& v) {
  std::vector<gaussgen::ir::NodeId> result;
  for (const auto e : v) result.push_back(e.id());
  return result;
}

Eigen::MatrixXd matrix(Evaluator<double>& evaluator, const gaussgen::strategy::Matrix& m, Eigen::Index columns) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(m.size()), columns);
  for (Eigen::Index i = 0; i < result.rows(); ++i) result.row(i) = values(evaluator, nodes(m[static_cast<std::size_t>(i)]));
  return result;
}

double largest(const Eigen::VectorXd& v) { return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff(); }

/// The problem in units in which masses and constraint rows are of size 1.
struct Scaling {
  Eigen::VectorXd speed;       ///< sqrt(g_αα)
  Eigen::VectorXd constraint;  ///< length of each row of b in the mass metric
  double condition = 1;        ///< of the scaled g and, with constraints, of the scaled [g bᵀ; b 0]
};

double condition(const Eigen::MatrixXd& m) {
  const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(m).singularValues();
  return s.size() == 0 ? 1.0 : s[0] / s[s.size() - 1];
}

Scaling scaling(Evaluator<double>& evaluator, const gaussgen::strategy::Dynamics& dynamics) {
  const auto n = static_cast<Eigen::Index>(dynamics.n());
  const auto l = static_cast<Eigen::Index>(dynamics.l());
  const Eigen::MatrixXd g = matrix(evaluator, dynamics.g, n);
  const Eigen::MatrixXd b = matrix(evaluator, dynamics.b, n);
  Scaling result;
  result.speed = g.diagonal().cwiseSqrt();
  const Eigen::VectorXd inverse = result.speed.cwiseInverse();
  const Eigen::MatrixXd scaled_g = inverse.asDiagonal() * g * inverse.asDiagonal();
  const Eigen::MatrixXd rows = b * inverse.asDiagonal();
  result.constraint = rows.rowwise().norm();
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + l, n + l);
  kkt.topLeftCorner(n, n) = scaled_g;
  if (l > 0) {
    const Eigen::MatrixXd unit_rows = result.constraint.cwiseInverse().asDiagonal() * rows;
    kkt.bottomLeftCorner(l, n) = unit_rows;
    kkt.topRightCorner(n, l) = unit_rows.transpose();
  }
  result.condition = std::max(condition(scaled_g), condition(kkt));
  return result;
}

/// ‖[c; 1]‖ in scaled units, squared: what a fixed choice of dependent speeds multiplies the condition of g by, since it
/// solves Cᵀ g C. It has no bound where det b_μρ can vanish, which is why the emitted route then makes no such choice.
double elimination_factor(Evaluator<double>& evaluator, const Mechanics& mechanics, const Scaling& scale,
                          const std::vector<std::string>& dependent) {
  const auto l = static_cast<Eigen::Index>(dependent.size());
  if (l == 0) return 1;
  const auto n = static_cast<Eigen::Index>(mechanics.dynamics.n());
  const Eigen::MatrixXd b = matrix(evaluator, mechanics.dynamics.b, n) * scale.speed.cwiseInverse().asDiagonal();
  Eigen::MatrixXd block(l, l);
  for (Eigen::Index j = 0; j < l; ++j) {
    const auto& labels = mechanics.dynamics.labels;
    const auto column = std::find(labels.begin(), labels.end(), dependent[static_cast<std::size_t>(j)]) - labels.begin();
    block.col(j) = b.col(column);
  }
  const double norm = Eigen::MatrixXd(block.fullPivLu().solve(b)).norm();
  return 1 + norm * norm;
}

/// Largest difference in scaled units over the size of the problem.
double difference(const Answer& x, const Answer& y, const Eigen::VectorXd& f, const Scaling& scale) {
  const Eigen::VectorXd force = f.cwiseQuotient(scale.speed);
  const double size = largest(x.a.cwiseProduct(scale.speed)) + largest(force) + largest(x.lambda.cwiseProduct(scale.constraint));
  const double a = largest((x.a - y.a).cwiseProduct(scale.speed)) / size;
  const double lambda = largest((x.lambda - y.lambda).cwiseProduct(scale.constraint)) / size;
  const double R = largest(x.R - y.R) / (largest(x.R) + size * scale.speed.maxCoeff());
  return std::max({a, lambda, R});
}

struct Tally {
  int compared = 0;
  int ill_conditioned = 0;
  int paper_ill_conditioned = 0;
  double worst_multiplier_form = 0;  ///< difference / (100 κ eps)
  double worst_paper = 0;
};

Tally compare(const std::string& file) {
  const auto model = agreement::load(file);
  Mechanics emitted(model, {});
  const auto paper = gaussgen::paper_route(emitted);
  REQUIRE(paper.obstacle.empty());
  Mechanics multipliers(model, {false, true});
  Evaluator<double> evaluator(emitted.graph, Arithmetic<double>());
  Evaluator<double> other(multipliers.graph, Arithmetic<double>());
  gaussgen::bind_parameters(emitted, evaluator);
  gaussgen::bind_parameters(multipliers, other);
  agreement::RandomStates states(emitted.symbols, 20261121);
  Tally tally;
  for (int i = 0; i < k_states; ++i) {
    const State state = states.next();
    bind(emitted.symbols, state, evaluator);
    bind(multipliers.symbols, state, other);
    const Scaling scale = scaling(evaluator, emitted.dynamics);
    if (!(scale.condition <= k_largest_condition)) {
      ++tally.ill_conditioned;
      std::printf("  %s: state %d has kappa = %.1e\n", file.c_str(), i, scale.condition);
      continue;
    }
    const Eigen::VectorXd f = values(evaluator, nodes(emitted.dynamics.f));
    const Answer ours{values(evaluator, nodes(emitted.solution.accelerations)),
                      values(evaluator, nodes(emitted.solution.multipliers)), values(evaluator, nodes(emitted.held_reactions))};
    const Answer kkt{values(other, nodes(multipliers.solution.accelerations)),
                     values(other, nodes(multipliers.solution.multipliers)), values(other, nodes(multipliers.held_reactions))};
    const Answer printed{values(evaluator, paper.accelerations), values(evaluator, paper.lambda), values(evaluator, paper.R_x)};
    const double bar = 100 * scale.condition * k_eps;
    // NaN compares false everywhere: take it as a failure.
    const auto worst = [&](double so_far, double now) { return now / bar <= so_far ? so_far : now / bar; };
    tally.worst_multiplier_form = worst(tally.worst_multiplier_form, difference(ours, kkt, f, scale));
    ++tally.compared;
    const double factor = elimination_factor(evaluator, emitted, scale, paper.dependent);
    if (!(scale.condition * factor <= k_largest_condition)) {
      ++tally.paper_ill_conditioned;
      std::printf("  %s: state %d, kappa of the paper's partition = %.1e\n", file.c_str(), i, scale.condition * factor);
      continue;
    }
    tally.worst_paper = worst(tally.worst_paper, difference(ours, printed, f, scale) / factor);
  }
  return tally;
}

}  // namespace

TEST_CASE("emitted route, multiplier form and paper's route agree to 100 kappa eps on 1000 states of every model") {
  std::printf("%-32s %8s %12s %16s %12s %14s\n", "model", "states", "kappa > 1e8", "multipliers/bar", "(partition)", "paper/bar");
  for (const std::string& file : agreement::model_files()) {
    const Tally tally = compare(file);
    std::printf("%-32s %8d %12d %16.3g %12d %14.3g\n", file.c_str(), tally.compared, tally.ill_conditioned,
                tally.worst_multiplier_form, tally.paper_ill_conditioned, tally.worst_paper);
    INFO(file);
    CHECK(tally.compared >= k_states * 9 / 10);
    CHECK(tally.paper_ill_conditioned <= k_states / 10);
    CHECK(tally.worst_multiplier_form <= 1);
    CHECK(tally.worst_paper <= 1);
  }
}
