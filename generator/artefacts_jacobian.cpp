#include <algorithm>
#include <limits>
#include <optional>

#include "artefact_builder.hpp"
#include "derivatives.hpp"
#include "ir/cost.hpp"

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

/// Columns `first` and on of `entries` as a sparse matrix. One without entries keeps a zero, so that every model has the same members.
Field sparse(const std::string& name, const std::string& type, const std::string& about, const Matrix& entries,
             std::size_t first, std::size_t count, NodeId zero) {
  emit::Pattern pattern{type, about, static_cast<int>(entries.size()), static_cast<int>(count), {0}, {}};
  std::vector<NodeId> values;
  for (const strategy::Vector& row : entries) {
    for (std::size_t j = 0; j < count; ++j) {
      if (row[first + j].is_zero()) continue;
      values.push_back(row[first + j].id());
      pattern.column.push_back(static_cast<int>(j));
    }
    pattern.row_begin.push_back(static_cast<int>(values.size()));
  }
  if (values.empty()) values.push_back(zero);
  const int size = static_cast<int>(values.size());
  const std::string contents = pattern.column.empty() ? "unused: nothing depends on it" : "entries of " + type;
  return {name, contents, {size}, std::move(values), std::move(pattern)};
}

void append(std::vector<Variable>& to, const std::vector<Variable>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Artefact> jacobian_artefact(Mechanics& mechanics) {
  std::vector<Variable> variables = state_variables(mechanics);
  const std::size_t n_state = variables.size(), n_inputs = mechanics.symbols.inputs.size();
  append(variables, input_variables(mechanics));
  append(variables, {time_variable(mechanics)});
  const Candidate found = cheapest(mechanics, variables);

  ArtefactBuilder builder("jacobian", k_about, mechanics);
  builder.result_type("Jacobian");
  std::vector<Field> fields;
  const auto add = [&](const char* name, const char* type, const std::string& by, std::size_t first,
                       std::size_t count) {
    const std::string about = "Where the entries of Jacobian::" + std::string(name) +
                              " are. Rows are in the order of Derivative, columns in that of " + by +
                              ". Row i has the entries row_begin[i] to row_begin[i + 1] - 1; entry k is in column[k].";
    fields.push_back(sparse(name, type, about, found.entries, first, count, mechanics.graph.constant(0)));
  };
  add("by_state", "JacobianByState", "State", 0, n_state);
  add("by_inputs", "JacobianByInputs", "Inputs", n_state, n_inputs);
  add("by_time", "JacobianByTime", "the time alone", n_state + n_inputs, 1);
  builder.fields("", "", "", std::move(fields));
  builder.with_solution_status();
  std::vector<Artefact> result;
  result.push_back(builder.finish(found.steps));
  return result;
}

}  // namespace gaussgen
