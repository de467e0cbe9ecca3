#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "artefact_builder.hpp"
#include "derivatives.hpp"
#include "given_solution.hpp"
#include "ir/cost.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using emit::NodeId;
using strategy::Matrix;
using strategy::Steps;

namespace {

const char* const k_about =
    "Derivatives of what rhs fills, rates of the configuration and accelerations, by the state, the inputs and the "
    "time: "
    "the entries that may differ from zero, row by row. JacobianByState and its like say where they are, and dense() "
    "writes the whole matrix.";

const char* const k_sides = "jacobian_sides";

/// A derivative of the rates with all that it takes.
struct Candidate {
  Matrix entries;
  Steps steps;
  int operations = 0;
};

Candidate derived(Mechanics& mechanics, const std::vector<Variable>& variables, DerivativeMethod method) {
  Candidate result;
  result.entries = jacobian(mechanics, variables, method, result.steps);
  std::vector<NodeId> roots;
  for (const strategy::Vector& row : result.entries) {
    for (const ir::Expr entry : row) roots.push_back(entry.id());
  }
  result.operations = ir::operations(mechanics.graph, roots);
  return result;
}

/// Up to this number of operations of the solution times variables, all ways are formed and counted.
constexpr double k_few_entries = 20'000;

/// How far a prediction may be off.
constexpr double k_margin = 1.5;

/// How many times fewer operations than with full rows a sparse metric may take.
constexpr double k_sparse = 2;

/// Whether the system over all speeds may be worth while: it is there, or its factorisation is no longer than what is known.
bool may_be_short(const Mechanics& mechanics, DerivativeMethod method, double variables, double best) {
  const bool is_over_speeds = method == DerivativeMethod::implicit || method == DerivativeMethod::reverse;
  if (!is_over_speeds || mechanics.solution.is_of_metric) return true;
  const auto n = static_cast<double>(mechanics.dynamics.n());
  return n * n * (n / 3 + 2 * variables) <= k_sparse * best;
}

/// All ways, or those of which some columns or rows say that they may be the cheapest.
std::vector<DerivativeMethod> promising_methods(Mechanics& mechanics, const std::vector<Variable>& variables) {
  const std::vector<DerivativeMethod> all = derivative_methods(mechanics);
  const double solution = ir::operations(mechanics.graph, ids(mechanics.solution.accelerations));
  const auto count = static_cast<double>(variables.size());
  if (all.size() == 1 || solution * count <= k_few_entries) return all;
  std::vector<std::pair<DerivativeMethod, double>> predicted;
  double best = std::numeric_limits<double>::infinity();
  for (const DerivativeMethod method : all) {
    if (!may_be_short(mechanics, method, count, best)) continue;
    const double whole = std::max(solution, predicted_operations(mechanics, variables, method));
    predicted.emplace_back(method, whole);
    best = std::min(best, whole);
  }
  std::vector<DerivativeMethod> result;
  for (const auto& [method, operations] : predicted) {
    if (operations <= k_margin * best) result.push_back(method);
  }
  return result;
}

Candidate cheapest(Mechanics& mechanics, const std::vector<Variable>& variables) {
  std::optional<Candidate> best;
  for (const DerivativeMethod method : promising_methods(mechanics, variables)) {
    Candidate other = derived(mechanics, variables, method);
    if (!best || other.operations < best->operations) best = std::move(other);
  }
  return *std::move(best);
}

void append(std::vector<Variable>& to, const std::vector<Variable>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// The state, the inputs, the time.
struct Variables {
  std::vector<Variable> all;
  std::size_t n_state = 0, n_inputs = 0;

  explicit Variables(const Mechanics& mechanics)
      : all(state_variables(mechanics)), n_state(all.size()), n_inputs(mechanics.symbols.inputs.size()) {
    append(all, input_variables(mechanics));
    append(all, {time_variable(mechanics)});
  }

  struct Block {
    const char* member;
    const char* type;
    const char* by;
    std::size_t first, count;
  };
  std::vector<Block> blocks() const {
    return {{"by_state", "JacobianByState", "State", 0, n_state},
            {"by_inputs", "JacobianByInputs", "Inputs", n_state, n_inputs},
            {"by_time", "JacobianByTime", "the time alone", n_state + n_inputs, 1}};
  }
};

/// Whether an entry of this row is kept.
using IsStored = std::function<bool(std::size_t row, ir::Expr entry)>;

/// Columns of a block of `entries` as a sparse matrix. One without entries keeps a zero, so that every model has the same members.
Field sparse(const Variables::Block& block, const std::string& about, const Matrix& entries, const IsStored& is_stored,
             NodeId zero) {
  emit::Pattern pattern{block.type, about, static_cast<int>(entries.size()), static_cast<int>(block.count), {0}, {}};
  std::vector<NodeId> values;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = 0; j < block.count; ++j) {
      const ir::Expr entry = entries[i][block.first + j];
      if (!is_stored(i, entry)) continue;
      values.push_back(entry.id());
      pattern.column.push_back(static_cast<int>(j));
    }
    pattern.row_begin.push_back(static_cast<int>(values.size()));
  }
  if (values.empty()) values.push_back(zero);
  const int size = static_cast<int>(values.size());
  const std::string contents =
      pattern.column.empty() ? "unused: nothing depends on it" : "entries of " + pattern.type_name;
  return {block.member, contents, {size}, std::move(values), std::move(pattern)};
}

ArtefactBuilder builder_of(Mechanics& mechanics, const Variables& variables, const Matrix& entries,
                           const IsStored& is_stored) {
  ArtefactBuilder builder("jacobian", k_about, mechanics);
  builder.result_type("Jacobian");
  std::vector<Field> fields;
  for (const Variables::Block& block : variables.blocks()) {
    const std::string about = "Where the entries of Jacobian::" + std::string(block.member) +
                              " are. Rows are in the order of Derivative, columns in that of " + block.by +
                              ". Row i has the entries row_begin[i] to row_begin[i + 1] - 1; entry k is in column[k].";
    fields.push_back(sparse(block, about, entries, is_stored, mechanics.graph.constant(0)));
  }
  builder.fields("", "", "", std::move(fields));
  return builder;
}

Artefact regular_jacobian(Mechanics& mechanics) {
  const Variables variables(mechanics);
  const Candidate found = cheapest(mechanics, variables.all);
  ArtefactBuilder builder =
      builder_of(mechanics, variables, found.entries, [](std::size_t, ir::Expr entry) { return !entry.is_zero(); });
  builder.with_solution_status();
  return builder.finish(found.steps);
}

/// Forces and drifts that derivatives of the accelerations are the answer to, of which the solution is given.
Artefact right_sides(Mechanics& mechanics, const Variables& variables) {
  Steps steps;
  Derivatives derivatives(mechanics, variables.all, DerivativeMethod::forward, steps);
  Matrix f, drift;
  for (std::size_t k = 0; k < derivatives.count(); ++k) {
    const strategy::Dynamics sides = derivatives.sides_by(k);
    f.push_back(sides.f);
    drift.push_back(sides.b_drift);
  }
  const int count = static_cast<int>(variables.all.size());
  const int n = static_cast<int>(mechanics.dynamics.n()), l = static_cast<int>(mechanics.dynamics.l());
  ArtefactBuilder builder(k_sides,
                          "Of jacobian: by each variable, in the order of state, inputs and time, what the same linear "
                          "system has on the right.",
                          mechanics);
  builder.with_any_quaternion();
  builder.result_type("JacobianSides");
  builder.fields(
      "", "", "",
      {{"f", "f' - g' a + b'^T lambda", {count, n}, ids(f)}, {"drift", "drift' + b' a", {count, l}, ids(drift)}});
  return builder.finish(steps);
}

/// Where constraints always follow from others: accelerations are of the general solution, and so are their derivatives, all of which are stored.
std::vector<Artefact> general_jacobian(Mechanics& mechanics) {
  const Variables variables(mechanics);
  const std::size_t n_q = mechanics.symbols.configuration.size(), n = mechanics.dynamics.n();
  const GivenSolution given(mechanics);
  Steps steps;
  Derivatives derivatives(mechanics, variables.all, DerivativeMethod::forward, steps);
  Matrix entries(n_q + n);
  for (std::size_t k = 0; k < derivatives.count(); ++k) {
    derivatives.by(k);
    for (std::size_t i = 0; i < n_q + n; ++i)
      entries[i].push_back(
          i < n_q ? derivatives(mechanics.kinematics.configuration_rates[kinematics::ConfigurationIndex{i}])
                  : mechanics.expressions.number(0));
  }
  Artefact of_solution = builder_of(mechanics, variables, entries, [n_q](std::size_t row, ir::Expr entry) {
                           return row >= n_q || !entry.is_zero();
                         }).finish(steps);
  emit::Rates rates{k_sides, "JacobianSides", static_cast<int>(variables.all.size()), static_cast<int>(n), {}};
  for (const Variables::Block& block : variables.blocks()) {
    const auto& fields = of_solution.groups.front().fields;
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&](const Field& one) { return one.name == block.member; });
    if (block.count > 0)
      rates.blocks.push_back(
          {block.member, field->pattern->row_begin[n_q], static_cast<int>(block.count), static_cast<int>(block.first)});
  }
  Artefact sides = right_sides(mechanics, variables);
  sides.takes_solution = true;
  sides.is_part = true;
  std::vector<Artefact> result{std::move(sides)};
  for (Artefact& one : of_general_solution(std::move(of_solution), std::move(rates), mechanics))
    result.push_back(std::move(one));
  return result;
}

}  // namespace

std::vector<Artefact> jacobian_artefact(Mechanics& mechanics) {
  if (has_general_way(mechanics) && usual_rank(mechanics) < mechanics.dynamics.l()) return general_jacobian(mechanics);
  std::vector<Artefact> result;
  result.push_back(regular_jacobian(mechanics));
  return result;
}

}  // namespace gaussgen
