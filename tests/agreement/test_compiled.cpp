// Compiled double against the same model in 50 digits, at exactly the same parameters and states.

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>

#include "catch_shim.hpp"
#include "compiled_model.hpp"
#include "conditioning.hpp"
#include "evaluate/decimal.hpp"
#include "ir/traverse.hpp"
#include "models.hpp"
#include "strategy/body_reactions.hpp"

namespace {

using agreement::CompiledModel;
using cln::cl_F;
using gaussgen::Mechanics;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;
using gaussgen::evaluate::Scaled;
using gaussgen::ir::Expr;
using gaussgen::ir::NodeId;
using gaussgen::ir::SymbolId;

constexpr int k_digits = 50;
constexpr int k_states = 1000;
/// Forces on bodies and accelerations are from two functions, whose solutions differ by up to 100 κ eps.
constexpr double k_own_solution = 100.0 / 64;
constexpr double k_largest_condition = 1e8;
constexpr double k_eps = 2.220446049250313e-16;
constexpr double k_nothing = 1e-20;

/// How far a result moves per relative change of the time: with Omega t in it, its rounding counts Omega t times.
constexpr double k_time_shift = 0x1p-26;
agreement::State later(agreement::State state) {
  state.time *= 1 + k_time_shift;
  return state;
}

/// 50 digits, alone and with absolute sums; every input is a double and taken as exact.
class Reference {
 public:
  explicit Reference(Mechanics& mechanics)
      : mechanics_(mechanics),
        exact_(k_digits),
        values_(mechanics.graph, exact_),
        evaluator_(mechanics.graph, Arithmetic<Scaled<cl_F>>(exact_)) {}

  void bind(SymbolId symbol, double value) {
    values_.bind(symbol, exact_.number(value));
    evaluator_.bind(symbol, evaluator_.arithmetic().input(exact_.number(value)));
  }

  void bind(const agreement::State& state) {
    const auto& symbols = mechanics_.symbols;
    bind(symbols.time, state.time);
    for (const auto i : symbols.configuration.indices())
      bind(symbols.configuration[i].symbol, state.configuration[i.value]);
    for (const auto i : symbols.speeds.indices()) bind(symbols.speeds[i].symbol, state.speeds[i.value]);
  }

  /// Plain parameters as compiled; formulas follow from them.
  void bind_parameters(const std::vector<double>& plain) {
    gaussgen::bind_parameters(mechanics_, values_);
    gaussgen::bind_parameters(mechanics_, evaluator_);
    std::size_t next = 0;
    const auto& parameters = mechanics_.model.parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (!parameters[i].is_formula) {
        bind(mechanics_.symbols.parameters[i], plain.at(next++));
        continue;
      }
      const NodeId formula = mechanics_.expressions(parameters[i].value).id();
      values_.bind(mechanics_.symbols.parameters[i], *values_(formula));
      evaluator_.bind(mechanics_.symbols.parameters[i], *evaluator_(formula));
    }
    REQUIRE(next == plain.size());
  }

  double value(NodeId node) { return gaussgen::evaluate::to_double(exact_value(node)); }

  double difference(NodeId node, double compiled) {
    return gaussgen::evaluate::to_double(exact_.number(compiled) - exact_value(node));
  }

  /// |compiled - exact| / (eps S)
  double error(NodeId node, double compiled) {
    const auto bounded = evaluator_(node);
    REQUIRE(bounded);
    const Scaled<cl_F>& reference = *bounded;
    // A row that nothing enters but its own zero, as that of a height beside forces of order 1, is left with 1e-30 of theirs.
    if (std::fabs(gaussgen::evaluate::to_double(reference.scale)) < k_nothing && std::fabs(compiled) < k_nothing)
      return 0;
    if (cln::zerop(reference.scale)) return compiled == 0 ? 0 : HUGE_VAL;
    return gaussgen::evaluate::to_double(cln::abs(exact_.number(compiled) - reference.value) / reference.scale) / k_eps;
  }

 private:
  cl_F exact_value(NodeId node) {
    const auto value = values_(node);
    REQUIRE(value);
    return *value;
  }

  Mechanics& mechanics_;
  Arithmetic<cl_F> exact_;
  Evaluator<cl_F> values_;
  Evaluator<Scaled<cl_F>> evaluator_;
};

bool is_division_free(const gaussgen::ir::Graph& graph, NodeId root) {
  for (const NodeId id : gaussgen::ir::post_order(graph, {root})) {
    const auto& node = graph[id];
    if (node.kind == gaussgen::ir::Kind::power && node.value < 0) return false;
  }
  return true;
}

std::vector<NodeId> nodes_of(const std::string& output, Mechanics& mechanics) {
  std::vector<NodeId> nodes;
  for (const auto& artefact : gaussgen::build_artefact(output, mechanics)) {
    if (artefact.name != output) continue;
    for (const auto& group : artefact.groups) {
      for (const auto& field : group.fields) nodes.insert(nodes.end(), field.values.begin(), field.values.end());
    }
  }
  return nodes;
}

/// What should vanish at the compiled accelerations, multipliers, reactions and forces.
struct Equations {
  std::vector<Expr> rows;
  std::vector<SymbolId> multipliers;
  std::vector<SymbolId> held;
  std::vector<SymbolId> forces;  ///< in the order of ReactionForces
  std::vector<Expr> sums;  ///< rows of forces on bodies, which a function of its own finds by accelerations of its own
  std::vector<Expr> wrenches;  ///< rows as well, but with G^-1 in them: S says nothing there
};

/// A symbol for each compiled component, less what it is of the compiled accelerations and reactions.
void add_forces(Mechanics& mechanics, const gaussgen::strategy::Solution& given, const gaussgen::strategy::Vector& held,
                Equations& result) {
  if (mechanics.dynamics.l() + held.size() == 0) return;
  const auto add = [&](const gaussgen::ir::Vector3& v, std::vector<Expr>& rows) {
    for (const Expr component : v) {
      const std::string name = "force_" + std::to_string(result.forces.size());
      result.forces.push_back(mechanics.graph.declare(gaussgen::ir::SymbolClass::opaque, name));
      rows.push_back(mechanics.expressions.symbol(result.forces.back()) - component);
    }
  };
  gaussgen::strategy::Steps steps;
  for (const auto& wrench :
       gaussgen::strategy::reaction_wrenches(mechanics.dynamics, given, held, mechanics.epsilon(), steps).each) {
    add(wrench.force, result.wrenches);
    if (wrench.moment) add(*wrench.moment, result.wrenches);
  }
  for (const auto& sum : gaussgen::strategy::body_reactions_by_speeds(mechanics.dynamics, given, steps)) {
    add(sum.force, result.sums);
    if (sum.moment) add(*sum.moment, result.sums);
  }
}

// g a - f - bᵀ λ, b a + drift, and R_j - (A_j - Q_j - λ_μ β_μj): theory, section 4, as it stands.
Equations equations(Mechanics& mechanics) {
  Equations result;
  const auto& dynamics = mechanics.dynamics;
  const auto& symbols = mechanics.symbols;
  std::vector<Expr> a;
  std::vector<Expr> lambda;
  for (const auto& speed : symbols.speeds) a.push_back(mechanics.expressions.symbol(speed.acceleration));
  for (const std::string& name : dynamics.constraints) {
    result.multipliers.push_back(mechanics.graph.declare(gaussgen::ir::SymbolClass::opaque, "lambda_" + name));
    lambda.push_back(mechanics.expressions.symbol(result.multipliers.back()));
  }
  for (std::size_t i = 0; i < dynamics.n(); ++i) {
    Expr row = -dynamics.f[i];
    for (std::size_t j = 0; j < dynamics.n(); ++j) row += dynamics.g[i][j] * a[j];
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu) row -= dynamics.b[mu][i] * lambda[mu];
    result.rows.push_back(row);
  }
  for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
    Expr row = dynamics.b_drift[mu];
    for (std::size_t j = 0; j < dynamics.n(); ++j) row += dynamics.b[mu][j] * a[j];
    result.rows.push_back(row);
  }
  gaussgen::strategy::Solution given = mechanics.solution;
  given.accelerations = a;
  given.multipliers = lambda;
  gaussgen::strategy::Steps steps;
  const gaussgen::strategy::Vector expected = gaussgen::strategy::held_reactions_by_metric(dynamics, given, steps);
  gaussgen::strategy::Vector held;
  for (const auto j : symbols.held.indices()) {
    result.held.push_back(mechanics.graph.declare(gaussgen::ir::SymbolClass::opaque, "R_" + symbols.held[j].name));
    held.push_back(mechanics.expressions.symbol(result.held.back()));
    result.rows.push_back(held.back() - expected[j.value]);
  }
  add_forces(mechanics, given, held, result);
  return result;
}

void bind_forces(const Equations& equations, const std::vector<double>& forces, Reference& reference) {
  REQUIRE(equations.forces.size() == forces.size());
  for (std::size_t i = 0; i < forces.size(); ++i) reference.bind(equations.forces[i], forces[i]);
}

/// Multipliers and held reactions among the flattened Reactions: every constraint has its multiplier and n generalized
/// components, every held coordinate one number.
void bind_reactions(const Equations& equations, const Mechanics& mechanics, const std::vector<double>& reactions,
                    Reference& reference) {
  std::size_t next = 0;
  for (const SymbolId symbol : equations.multipliers) {
    reference.bind(symbol, reactions.at(next));
    next += 1 + mechanics.dynamics.n();
  }
  for (const SymbolId symbol : equations.held) reference.bind(symbol, reactions.at(next++));
  REQUIRE(next == reactions.size());
}

constexpr double k_most_backward = 64;  ///< eps

struct Worst {
  double division_free = 0;
  double backward = 0;
  double solved = 0;
  int ill_conditioned = 0;
};

void take(double& worst, double now) {
  if (!(now <= worst)) worst = now;
}

/// Of the metric of all y, scaled to a diagonal of 1.
double condition_of_metric(const Mechanics& mechanics, Reference& reference) {
  const auto& G = mechanics.covariant->G;
  const auto n = static_cast<Eigen::Index>(mechanics.symbols.full_count());
  Eigen::MatrixXd metric(n, n);
  for (const auto i : G.indices()) {
    for (const auto j : G.indices()) {
      metric(static_cast<Eigen::Index>(i.value), static_cast<Eigen::Index>(j.value)) = reference.value(G[i][j].id());
    }
  }
  const Eigen::VectorXd size = metric.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = size.asDiagonal() * metric * size.asDiagonal();
  const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(scaled).singularValues();
  return s[0] / s[n - 1];
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::fabs(value));
  return result;
}

/// One compiled model beside the same model in 50 digits.
class Measurement {
 public:
  explicit Measurement(const CompiledModel& compiled)
      : compiled_(compiled),
        model_(agreement::load(compiled.file)),
        mechanics_(model_, {}),
        system_(equations(mechanics_)),
        direct_{{nodes_of("energy", mechanics_), compiled.energy},
                {nodes_of("mass_matrix", mechanics_), compiled.mass_matrix}},
        Z_(nodes_of("compulsion", mechanics_)),
        reference_(mechanics_),
        doubles_(mechanics_.graph, gaussgen::evaluate::Arithmetic<double>()) {
    gaussgen::bind_parameters(mechanics_, doubles_);
    if (compiled.residuals) direct_.emplace_back(nodes_of("residuals", mechanics_), compiled.residuals);
    REQUIRE(Z_.empty() != static_cast<bool>(compiled.compulsion));
    reference_.bind_parameters(compiled.parameters);
  }

  Worst run() {
    agreement::RandomStates states(mechanics_.symbols, 50);
    for (int s = 0; s < k_states; ++s) at(states.next());
    return worst_;
  }

 private:
  void at(const agreement::State& state) {
    std::vector<double> y = state.configuration;
    y.insert(y.end(), state.speeds.begin(), state.speeds.end());
    compiled_.set(state.time, y);
    reference_.bind(state);
    bind_accelerations(accelerations_in(compiled_.rhs()));
    for (const auto& [nodes, values] : direct_) measure_direct(nodes, values());
    const std::vector<double> forces = compiled_.reactions ? compiled_.reaction_forces() : std::vector<double>{};
    if (compiled_.reactions) {
      // Of one solution: rhs and reactions, each alone, round in ways of their own, and near singular states these are far apart.
      const auto [rates, reactions] = compiled_.rhs_and_reactions();
      bind_accelerations(accelerations_in(rates));
      bind_reactions(system_, mechanics_, reactions, reference_);
      bind_forces(system_, forces, reference_);
    }
    for (std::size_t i = 0; i < system_.rows.size(); ++i) {
      const double error = reference_.error(system_.rows[i].id(), 0);
      if (!(error <= k_most_backward)) std::printf("  row %zu: %.3g eps\n", i, error);
      take(worst_.backward, error);
    }
    const double condition = system_.sums.empty() ? 1 : condition_at(state);
    for (const Expr& row : system_.sums)
      take(worst_.backward, reference_.error(row.id(), 0) / (k_own_solution * condition));
    measure_solved(state, forces);
  }

  std::vector<double> accelerations_in(const std::vector<double>& derivative) const {
    return {derivative.begin() + static_cast<std::ptrdiff_t>(mechanics_.symbols.configuration.size()),
            derivative.end()};
  }

  /// Of the metric and of the constrained system, scaled.
  double condition_at(const agreement::State& state) {
    agreement::bind(mechanics_.symbols, state, doubles_);
    return std::max(condition_of_metric(mechanics_, reference_),
                    agreement::scaling(doubles_, mechanics_.dynamics).condition);
  }

  void bind_accelerations(const std::vector<double>& a) {
    for (const auto i : mechanics_.symbols.speeds.indices())
      reference_.bind(mechanics_.symbols.speeds[i].acceleration, a[i.value]);
  }

  void measure_direct(const std::vector<NodeId>& nodes, const std::vector<double>& results) {
    REQUIRE(results.size() == nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (is_division_free(mechanics_.graph, nodes[i]))
        take(worst_.division_free, reference_.error(nodes[i], results[i]));
    }
  }

  // Wrenches and Z contain G^-1. Lengths are of order 1, so the largest of forces and moments is a size for both; that of Z
  // is its value where nothing accelerates, from which it comes down.
  void measure_solved(const agreement::State& state, const std::vector<double>& forces) {
    const double condition = condition_of_metric(mechanics_, reference_);
    if (!(condition <= k_largest_condition)) {
      ++worst_.ill_conditioned;
      return;
    }
    const std::vector<double> off = solved_errors();
    reference_.bind(later(state));
    const std::vector<double> off_later = solved_errors();
    reference_.bind(state);
    bind_accelerations(std::vector<double>(mechanics_.dynamics.n(), 0.0));
    for (std::size_t i = 0; i < off.size(); ++i) {
      const bool is_Z = !Z_.empty() && i + 1 == off.size();
      const double size = is_Z ? compiled_.compulsion().at(0) + reference_.value(Z_[0]) : largest(forces);
      const double per_time = std::fabs(off_later[i] - off[i]) / k_time_shift;
      take(worst_.solved, std::fabs(off[i]) / (100 * k_eps * (condition * size + per_time)));
    }
  }

  /// How far compiled wrenches are off, and Z at the end.
  std::vector<double> solved_errors() {
    std::vector<double> off;
    // Without constraints nothing but the forces along coordinates would be in them, and no such output is emitted.
    if (compiled_.reactions) {
      for (const Expr& row : system_.wrenches) off.push_back(reference_.value(row.id()));
    }
    if (!Z_.empty()) off.push_back(reference_.difference(Z_[0], compiled_.compulsion().at(0)));
    return off;
  }

  const CompiledModel& compiled_;
  gaussgen::model::Model model_;
  Mechanics mechanics_;
  Equations system_;
  std::vector<std::pair<std::vector<NodeId>, std::function<std::vector<double>()>>> direct_;
  std::vector<NodeId> Z_;
  Reference reference_;
  gaussgen::evaluate::Evaluator<double> doubles_;
  Worst worst_;
};

}  // namespace

// The three kinds of bars: rounding of sums and products; residuals of the equations at compiled results; and 100 κ eps where
// a result contains the inverse of the metric of all coordinates, κ of that metric.
TEST_CASE(
    "compiled double against 50 digits: division-free outputs to 8 eps S, solved ones to a backward error of 64 eps") {
  std::printf("%-30s %22s %21s %23s %12s\n", "model", "division-free / eps S", "backward error / eps",
              "wrenches, Z / 100 k eps", "kappa > 1e8");
  for (const CompiledModel& compiled : agreement::compiled_models()) {
    const Worst worst = Measurement(compiled).run();
    std::printf("%-30s %22.3g %21.3g %23.3g %12d\n", compiled.file.c_str(), worst.division_free, worst.backward,
                worst.solved, worst.ill_conditioned);
    INFO(compiled.file);
    CHECK(worst.division_free <= 8);
    CHECK(worst.backward <= k_most_backward);
    CHECK(worst.solved <= 1);
    CHECK(worst.ill_conditioned <= k_states / 20);
  }
}
