// The entries of the Jacobian against difference quotients of the right-hand side, for every model.

#include "derivatives.hpp"

#include <algorithm>

#include "agreement/model_files.hpp"
#include "artefacts.hpp"
#include "catch_shim.hpp"
#include "ir/cost.hpp"
#include "numbers.hpp"

using namespace gaussgen;
using derivatives::Numbers;

namespace {

constexpr int k_states = 3;

struct Variables {
  std::vector<Variable> all;
  std::size_t states, inputs;
};

Variables variables_of(const Mechanics& mechanics) {
  Variables variables{state_variables(mechanics), 0, 0};
  variables.states = variables.all.size();
  for (const Variable& input : input_variables(mechanics)) variables.all.push_back(input);
  variables.inputs = variables.all.size() - variables.states;
  variables.all.push_back(time_variable(mechanics));
  return variables;
}

/// The whole matrix of an emitted Jacobian: zero where its patterns have no entry.
strategy::Matrix whole(const emit::Artefact& artefact, Mechanics& mechanics, const Variables& variables) {
  const ir::Expr zero(mechanics.graph, mechanics.graph.constant(0));
  strategy::Matrix result(state_rates(mechanics).size(), strategy::Vector(variables.all.size(), zero));
  for (const emit::Field& field : artefact.groups.at(0).fields) {
    const emit::Pattern& pattern = field.pattern.value();
    const std::size_t first = field.name == "by_state"    ? 0
                              : field.name == "by_inputs" ? variables.states
                                                          : variables.states + variables.inputs;
    REQUIRE(pattern.row_begin.size() == result.size() + 1);
    REQUIRE(field.values.size() == std::max<std::size_t>(pattern.column.size(), 1));
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (int k = pattern.row_begin[i]; k < pattern.row_begin[i + 1]; ++k) {
        const auto entry = static_cast<std::size_t>(k);
        REQUIRE(pattern.column[entry] < pattern.columns);
        result[i][first + static_cast<std::size_t>(pattern.column[entry])] = {mechanics.graph, field.values[entry]};
      }
    }
  }
  return result;
}

std::vector<ir::NodeId> column(const strategy::Matrix& matrix, std::size_t k) {
  std::vector<ir::NodeId> ids;
  for (const strategy::Vector& row : matrix) ids.push_back(row[k].id());
  return ids;
}

/// The largest deviation over some states at which the right-hand side has a value.
double deviation_at_states(Mechanics& mechanics, const strategy::Matrix& found, const Variables& variables) {
  std::vector<ir::NodeId> rates;
  for (const ir::Expr rate : state_rates(mechanics)) rates.push_back(rate.id());
  agreement::RandomStates states(mechanics.symbols, 7);
  double worst = 0;
  int seen = 0;
  for (int tries = 0; seen < k_states && tries < 10 * k_states; ++tries) {
    Numbers numbers(mechanics, states.next());
    if (numbers(rates).empty()) continue;
    ++seen;
    for (std::size_t k = 0; k < variables.all.size(); ++k) {
      const auto quotient = numbers.quotient(rates, variables.all[k].symbol);
      const auto derivative = numbers(column(found, k));
      INFO("by " << variables.all[k].name);
      REQUIRE(quotient.size() == rates.size());
      REQUIRE(derivative.size() == rates.size());
      worst = std::max(worst, derivatives::deviation(derivative, quotient));
    }
  }
  REQUIRE(seen == k_states);
  return worst;
}

}  // namespace

TEST_CASE(
    "the Jacobian of every model is the difference quotient of its right-hand side, and zero where it has no entry") {
  for (const std::string& file : agreement::model_files()) {
    INFO(file);
    const model::Model model = agreement::load(file);
    Mechanics mechanics(model, {});
    const Variables variables = variables_of(mechanics);
    const auto artefacts = build_artefact("jacobian", mechanics);
    REQUIRE(artefacts.size() == 1);
    const double worst = deviation_at_states(mechanics, whole(artefacts[0], mechanics, variables), variables);
    std::printf("%-30s %10.2g\n", file.c_str(), worst);
    CHECK(worst < derivatives::k_tolerance);
  }
}

TEST_CASE("each method gives the same derivatives: by the system, through its solution, backwards, and link by link") {
  for (const char* file : {"double_pendulum", "chain", "functions", "rolling_disc", "four_bar", "skew_nonholonomic",
                           "rattleback", "lagrange_top", "bicycle", "robot_arm", "double_pendulum_points",
                           "families/planar_chain_relative", "families/spatial_chain", "families/tree"}) {
    INFO(file);
    const model::Model model = agreement::load(file);
    Mechanics mechanics(model, {});
    const Variables variables = variables_of(mechanics);
    for (const DerivativeMethod method : derivative_methods(mechanics)) {
      strategy::Steps steps;
      const strategy::Matrix found = jacobian(mechanics, variables.all, method, steps);
      CHECK(deviation_at_states(mechanics, found, variables) < derivatives::k_tolerance);
      std::vector<ir::NodeId> all;
      for (std::size_t k = 0; k < variables.all.size(); ++k) {
        for (const ir::NodeId id : column(found, k)) all.push_back(id);
      }
      std::printf("%-30s method %d: %d operations\n", file, static_cast<int>(method),
                  ir::operations(mechanics.graph, all));
    }
  }
}

namespace {

model::Model chain_of(int n) {
  support::Source source("chain.yaml", "gauss: 1\nname: chain\ncounts: {n: " + std::to_string(n) + R"(}
parameters: {m: 1.3, L: 0.7, J: 0.05, g: 9.81}
joints:
  hinge_1: {type: revolute, child: link_1, axis: y, coordinates: q_1, initial: 0.3}
  hinge_$(i+1): {count: $(n-1), type: revolute, parent: link_$i, child: link_$(i+1), at: [0, 0, -L], axis: y, coordinates: q_$(i+1), initial: 0.1}
bodies:
  body_$i: {count: n, frame: link_$i, mass: m, inertia: J, centre: [0, 0, -L/2]}
forces:
  gravity: {uniform: [0, 0, -g]}
)");
  support::Diagnostics diagnostics;
  auto model = read_model(source, diagnostics);
  REQUIRE(model);
  return *std::move(model);
}

/// Operations and nodes of the Jacobian of a chain, parameters folded.
std::pair<double, double> size_of_jacobian(int n) {
  const model::Model model = chain_of(n);
  Mechanics mechanics(model, {true});
  const auto artefacts = build_artefact("jacobian", mechanics);
  std::vector<ir::NodeId> entries;
  for (const emit::Field& field : artefacts.at(0).groups.at(0).fields)
    entries.insert(entries.end(), field.values.begin(), field.values.end());
  return {ir::operations(mechanics.graph, entries), static_cast<double>(mechanics.graph.size())};
}

}  // namespace

TEST_CASE("the Jacobian of a chain takes operations and nodes for each entry, at no size a leap") {
  const auto [of_20, nodes_of_20] = size_of_jacobian(20);
  const auto [of_28, nodes_of_28] = size_of_jacobian(28);
  const auto [of_30, nodes_of_30] = size_of_jacobian(30);
  const auto [of_40, nodes_of_40] = size_of_jacobian(40);
  CHECK(of_30 / of_28 < 1.2);
  CHECK(of_40 / of_20 < 4.1);
  CHECK(nodes_of_40 / nodes_of_20 < 4.1);
  CHECK(of_40 < 30 * 40 * 80);  // 2 n columns with n accelerations each
}

TEST_CASE(
    "a tree is differentiated link by link, and limbs only follow what they hang on where nothing in them changes") {
  for (const char* file : {"families/quadruped", "families/humanoid"}) {
    INFO(file);
    const model::Model model = agreement::load(file);
    Mechanics mechanics(model, {true});
    strategy::Steps steps;
    const strategy::TreeTangent tangent =
        strategy::tree_tangent(mechanics.dynamics, mechanics.solution, mechanics.epsilon(), steps);
    CHECK(tangent.limbs.size() >= 4);
    const Variables variables = variables_of(mechanics);
    std::vector<Variable> some;
    for (std::size_t k = 0; k < variables.all.size(); k += 7) some.push_back(variables.all[k]);
    const strategy::Matrix by_links = jacobian(mechanics, some, DerivativeMethod::links, steps);
    const strategy::Matrix through = jacobian(mechanics, some, DerivativeMethod::forward, steps);
    agreement::RandomStates states(mechanics.symbols, 7);
    Numbers numbers(mechanics, states.next());
    for (std::size_t k = 0; k < some.size(); ++k) {
      INFO("by " << some[k].name);
      CHECK(derivatives::deviation(numbers(column(by_links, k)), numbers(column(through, k))) <
            derivatives::k_tolerance);
    }
  }
}
