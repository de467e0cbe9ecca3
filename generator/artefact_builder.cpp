#include "artefact_builder.hpp"

#include <algorithm>

#include "strategy/quaternions.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using emit::Group;
using emit::NodeId;
using ir::Expr;
using strategy::Steps;

std::vector<NodeId> ids(const strategy::Vector& values) {
  std::vector<NodeId> result;
  for (const Expr value : values) result.push_back(value.id());
  return result;
}

std::vector<NodeId> ids(const ir::Vector3& v) { return {v[0].id(), v[1].id(), v[2].id()}; }

std::vector<NodeId> ids(const strategy::Matrix& rows) {
  std::vector<NodeId> result;
  for (const strategy::Vector& row : rows) {
    const std::vector<NodeId> of_row = ids(row);
    result.insert(result.end(), of_row.begin(), of_row.end());
  }
  return result;
}

strategy::Vector gradient_of(const Mechanics& mechanics, const kinematics::ConstraintRow& row) {
  strategy::Vector gradient;
  for (const auto i : mechanics.symbols.speeds.indices()) gradient.push_back(row.beta[mechanics.symbols.full(i)]);
  return gradient;
}

strategy::Vector configuration_of(const Mechanics& mechanics) {
  strategy::Vector configuration;
  for (const auto& q : mechanics.symbols.configuration) configuration.push_back(mechanics.expressions.symbol(q.symbol));
  return configuration;
}

strategy::Vector candidate_accelerations(const Mechanics& mechanics) {
  strategy::Vector candidate;
  for (const auto& speed : mechanics.symbols.speeds)
    candidate.push_back(mechanics.expressions.symbol(speed.acceleration));
  return candidate;
}

ArtefactBuilder::ArtefactBuilder(std::string name, std::string about, Mechanics& mechanics) : mechanics_(mechanics) {
  artefact_.name = std::move(name);
  artefact_.about = std::move(about);
  const NodeId never = mechanics.graph.constant(0);
  const strategy::Vector norms = strategy::squared_norms(mechanics.symbols, configuration_of(mechanics));
  artefact_.status = {never, never, never, strategy::is_off_unit_length(mechanics.graph, norms).id()};
}

void ArtefactBuilder::with_any_quaternion() { artefact_.status.violated_constraints = mechanics_.graph.constant(0); }

void ArtefactBuilder::result_type(const std::string& type) {
  artefact_.target = emit::Target::result;
  artefact_.result_type = type;
}

void ArtefactBuilder::fields(const std::string& name, const std::string& type, const std::string& about,
                             std::vector<Field> fields) {
  artefact_.groups.push_back(Group{name, type, about, std::move(fields)});
}

void ArtefactBuilder::with_singular_metric(ir::Expr is_singular) {
  NodeId& status = artefact_.status.singular_mass_matrix;
  status = ir::any(mechanics_.graph, {ir::Expr(mechanics_.graph, status), is_singular}).id();
}

void ArtefactBuilder::with_solution_status() {
  artefact_.status.singular_mass_matrix = mechanics_.solution.singular_mass_matrix.id();
  // What has a gradient of rounding where it holds asks for any acceleration.
  const auto& constraints = mechanics_.model.constraints;
  const bool holds_nothing = std::any_of(mechanics_.vanishing.begin(), mechanics_.vanishing.end(),
                                         [&](std::size_t mu) { return !constraints[mu].may_vanish; });
  artefact_.status.dependent_constraints =
      holds_nothing ? mechanics_.graph.constant(1) : mechanics_.solution.dependent_constraints.id();
  looked_at_ = mechanics_.solution.looked_at;
}

Artefact ArtefactBuilder::finish(const Steps& own) {
  add_sections(mechanics_.metric_steps.all());
  add_sections(mechanics_.steps.all());
  add_sections(own.all());
  artefact_.status.not_finite = not_finite();
  return std::move(artefact_);
}

void ArtefactBuilder::add_sections(const std::vector<strategy::Step>& steps) {
  for (const strategy::Step& step : steps) artefact_.sections.push_back({step.comment, step.subject, step.values});
}

// The emitter adds the arguments of the function, since a NaN in one that nothing depends on would not reach an output.
NodeId ArtefactBuilder::not_finite() const {
  std::vector<NodeId> values = artefact_.derivative;
  values.insert(values.end(), looked_at_.begin(), looked_at_.end());
  values.insert(values.end(), artefact_.state.begin(), artefact_.state.end());
  for (const Group& group : artefact_.groups) {
    for (const Field& field : group.fields) values.insert(values.end(), field.values.begin(), field.values.end());
  }
  ir::Graph& graph = mechanics_.graph;
  values.erase(
      std::remove_if(values.begin(), values.end(), [&](NodeId id) { return graph[id].kind == ir::Kind::constant; }),
      values.end());
  return values.empty() ? graph.constant(0) : graph.call(ir::Function::not_finite, values);
}

}  // namespace gaussgen
