#include "dumps.hpp"

#include <fmt/format.h>

#include "ir/cost.hpp"
#include "ir/print.hpp"

namespace gaussgen {

namespace {

using ir::Expr;
using ir::Vector3;

/// A named node prints as what it stands for, since its name is on the left already.
std::string text(const ir::Graph& graph, ir::NodeId id) {
  const ir::Node& node = graph[id];
  return ir::print(graph, node.kind == ir::Kind::named ? node.children[0] : id);
}

std::string text(Expr expression) { return text(expression.graph(), expression.id()); }

std::string text(const Vector3& v) { return fmt::format("[{}, {}, {}]", text(v[0]), text(v[1]), text(v[2])); }

std::string line(const std::string& name, const std::string& value) { return fmt::format("  {} = {}\n", name, value); }

std::string dump_body(const kinematics::BodyMotion& body, const kinematics::Symbols& symbols) {
  std::string result = fmt::format("body {}: dv/dt = J_A d2y^A/dt2 + h\n", body.name);
  result += line("position", text(body.position)) + line("velocity", text(body.velocity));
  for (const auto i : body.J.indices()) {
    if (!is_zero(body.J[i])) result += line("J_" + symbols.label(i), text(body.J[i]));
  }
  result += line("h", text(body.h));
  if (!body.is_rigid) return result;
  const char* const frame = body.rotation.axes == model::Axes::space ? "space" : "body";
  result += fmt::format("  in the {} frame:\n", frame) + line("omega", text(body.rotation.omega));
  for (const auto i : body.W.indices()) {
    if (!is_zero(body.W[i])) result += line("W_" + symbols.label(i), text(body.W[i]));
  }
  return result + line("eta", text(body.eta));
}

std::string dump_row(const kinematics::ConstraintRow& row, const kinematics::Symbols& symbols) {
  std::string result =
      fmt::format("constraint {}: dphi/dt = beta_A d2y^A/dt2 + drift\n", row.name) + line("phi", text(row.phi));
  for (const auto i : row.beta.indices()) {
    if (!row.beta[i].is_zero()) result += line("beta_" + symbols.label(i), text(row.beta[i]));
  }
  return result + line("drift", text(row.beta_drift));
}

}  // namespace

std::string dump_kinematics(const Mechanics& mechanics) {
  std::string result;
  for (const auto& body : *mechanics.kinematics.bodies) result += dump_body(body, mechanics.symbols);
  for (const auto& row : mechanics.kinematics.constraints) result += dump_row(row, mechanics.symbols);
  return result;
}

namespace {

std::string dump_step(const ir::Graph& graph, const strategy::Step& step) {
  std::string result = "\n# " + step.comment + "\n";
  for (const auto& [node, name] : step.values) {
    if (!graph.is_zero(node)) result += line(name, text(graph, node));
  }
  return result;
}

}  // namespace

std::string dump_strategy(const Mechanics& mechanics) {
  std::string result = mechanics.solution.description + "\n";
  for (const strategy::Steps* steps : {&mechanics.metric_steps, &mechanics.steps}) {
    for (const strategy::Step& step : steps->all()) result += dump_step(mechanics.graph, step);
  }
  return result;
}

std::string dump_artefacts(const Mechanics& mechanics, const emit::Unit& unit) {
  std::string result;
  for (const emit::Artefact& artefact : unit.artefacts) {
    std::vector<ir::NodeId> roots = artefact.derivative;
    roots.insert(roots.end(), artefact.state.begin(), artefact.state.end());
    for (const emit::Group& group : artefact.groups) {
      for (const emit::Field& field : group.fields) roots.insert(roots.end(), field.values.begin(), field.values.end());
    }
    const auto count = ir::count_operations(mechanics.graph, roots);
    result += fmt::format("{:<18} {:>5} operations: {} + -, {} *, {} /, {} sqrt, {} functions\n", artefact.name,
                          count.total(), count.additions, count.multiplications, count.divisions, count.square_roots,
                          count.functions);
  }
  return result;
}

}  // namespace gaussgen
