// Compiled double against the same model in 50 digits, at exactly the same parameters and states.

#include <cmath>
#include <cstdio>

#include "catch_shim.hpp"
#include "compiled_model.hpp"
#include "evaluate/decimal.hpp"
#include "ir/traverse.hpp"
#include "models.hpp"

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
constexpr int k_states = 100;
constexpr double k_eps = 2.220446049250313e-16;

/// 50 digits with absolute sums; every input is a double and taken as exact.
class Reference {
 public:
  explicit Reference(Mechanics& mechanics)
      : mechanics_(mechanics), exact_(k_digits), evaluator_(mechanics.graph, Arithmetic<Scaled<cl_F>>(exact_)) {}

  void bind(SymbolId symbol, double value) { evaluator_.bind(symbol, evaluator_.arithmetic().input(exact_.number(value))); }

  void bind(const agreement::State& state) {
    const auto& symbols = mechanics_.symbols;
    bind(symbols.time, state.time);
    for (const auto i : symbols.configuration.indices()) bind(symbols.configuration[i].symbol, state.configuration[i.value]);
    for (const auto i : symbols.speeds.indices()) bind(symbols.speeds[i].symbol, state.speeds[i.value]);
  }

  /// Plain parameters as compiled; formulas follow from them.
  void bind_parameters(const std::vector<double>& plain) {
    gaussgen::bind_parameters(mechanics_, evaluator_);
    std::size_t next = 0;
    const auto& parameters = mechanics_.model.parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (!parameters[i].is_formula) {
        bind(mechanics_.symbols.parameters[i], plain.at(next++));
        continue;
      }
      const auto value = evaluator_(mechanics_.expressions(parameters[i].value).id());
      evaluator_.bind(mechanics_.symbols.parameters[i], *value);
    }
    REQUIRE(next == plain.size());
  }

  Scaled<cl_F> operator()(NodeId node) {
    const auto value = evaluator_(node);
    REQUIRE(value);
    return *value;
  }

  /// |compiled - exact| / (eps S)
  double error(NodeId node, double compiled) {
    const Scaled<cl_F> reference = (*this)(node);
    if (cln::zerop(reference.scale)) return compiled == 0 ? 0 : HUGE_VAL;
    return gaussgen::evaluate::to_double(cln::abs(exact_.number(compiled) - reference.value) / reference.scale) / k_eps;
  }

 private:
  Mechanics& mechanics_;
  Arithmetic<cl_F> exact_;
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

/// What should vanish at the compiled accelerations, multipliers and reactions.
struct Equations {
  std::vector<Expr> rows;
  std::vector<SymbolId> multipliers;
  std::vector<SymbolId> held;
};

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
  for (const auto j : symbols.held.indices()) {
    result.held.push_back(mechanics.graph.declare(gaussgen::ir::SymbolClass::opaque, "R_" + symbols.held[j].name));
    gaussgen::strategy::Solution given = mechanics.solution;
    given.accelerations = a;
    given.multipliers = lambda;
    gaussgen::strategy::Steps steps;
    result.rows.push_back(mechanics.expressions.symbol(result.held.back()) -
                          gaussgen::strategy::held_reactions(dynamics, given, steps)[j.value]);
  }
  return result;
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

struct Worst {
  double division_free = 0;
  double backward = 0;
};

void take(double& worst, double now) {
  if (!(now <= worst)) worst = now;
}

Worst measure(const CompiledModel& compiled) {
  const auto model = agreement::load(compiled.file);
  Mechanics mechanics(model, {});
  const Equations system = equations(mechanics);
  std::vector<std::pair<std::vector<NodeId>, std::function<std::vector<double>()>>> direct{
      {nodes_of("energy", mechanics), compiled.energy}, {nodes_of("mass_matrix", mechanics), compiled.mass_matrix}};
  if (compiled.residuals) direct.emplace_back(nodes_of("residuals", mechanics), compiled.residuals);
  Reference reference(mechanics);
  reference.bind_parameters(compiled.parameters);
  agreement::RandomStates states(mechanics.symbols, 50);
  const std::size_t n_q = mechanics.symbols.configuration.size();
  Worst worst;
  for (int s = 0; s < k_states; ++s) {
    const agreement::State state = states.next();
    std::vector<double> y = state.configuration;
    y.insert(y.end(), state.speeds.begin(), state.speeds.end());
    compiled.set(state.time, y);
    reference.bind(state);
    const std::vector<double> rates = compiled.rhs();
    for (const auto i : mechanics.symbols.speeds.indices()) {
      reference.bind(mechanics.symbols.speeds[i].acceleration, rates[n_q + i.value]);
    }
    for (const auto& [nodes, values] : direct) {
      const std::vector<double> results = values();
      REQUIRE(results.size() == nodes.size());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (is_division_free(mechanics.graph, nodes[i])) take(worst.division_free, reference.error(nodes[i], results[i]));
      }
    }
    if (compiled.reactions) bind_reactions(system, mechanics, compiled.reactions(), reference);
    for (const Expr& row : system.rows) take(worst.backward, reference.error(row.id(), 0));
  }
  return worst;
}

}  // namespace

TEST_CASE("compiled double against 50 digits: division-free outputs to 8 eps S, solved ones to a backward error of 64 eps") {
  std::printf("%-32s %22s %22s\n", "model", "division-free / eps S", "backward error / eps");
  for (const CompiledModel& compiled : agreement::compiled_models()) {
    const Worst worst = measure(compiled);
    std::printf("%-32s %22.3g %22.3g\n", compiled.file.c_str(), worst.division_free, worst.backward);
    INFO(compiled.file);
    CHECK(worst.division_free <= 8);
    CHECK(worst.backward <= 64);
  }
}
