#include "artefact_builder.hpp"
#include "artefacts.hpp"
#include "strategy/inverse_dynamics.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using strategy::Steps;
using strategy::Vector;

namespace {

const char* const k_about =
    "What makes given accelerations, which satisfy the constraints. missing: least generalized forces to be added to\n"
    "those at these inputs; multipliers stay what they are then.";
const char* const k_about_inputs =
    "\nneeded: what the inputs have to be instead, and the accelerations that result: the given ones, unless there are "
    "too few inputs.";

const char* const k_about_no_inputs =
    "\nneeded inputs are not found: none acts along a speed, or forces are not linear in them.";

void add_inputs(ArtefactBuilder& builder, const Mechanics& mechanics, const strategy::Drives& drives) {
  std::vector<Field> fields;
  for (std::size_t k = 0; k < drives.inputs.size(); ++k) {
    const model::Input& input = mechanics.model.inputs[drives.inputs[k]];
    fields.push_back({input.name.text, input.unit.empty() ? "" : "[" + input.unit + "]", {}, {drives.values[k].id()}});
  }
  builder.fields("needed", "NeededInputs", "what the inputs have to be", std::move(fields));
}

}  // namespace

std::vector<std::size_t> sought_inputs(const model::Model& model) {
  std::vector<std::size_t> sought;
  for (std::size_t k = 0; k < model.inputs.size(); ++k) {
    if (!model.inputs[k].is_load) sought.push_back(k);
  }
  return sought;
}

std::vector<Artefact> inverse_dynamics_artefact(Mechanics& mechanics) {
  const Vector wanted = candidate_accelerations(mechanics);
  Steps steps;
  const int n = static_cast<int>(mechanics.dynamics.n());
  const Vector missing = strategy::missing_forces(mechanics.dynamics, wanted, mechanics.solution.multipliers, steps);
  const std::vector<std::size_t> sought = sought_inputs(mechanics.model);
  const auto drives = strategy::drives(mechanics.dynamics, wanted, sought, mechanics.epsilon(), steps);
  const char* const about_inputs = drives ? k_about_inputs : sought.empty() ? "" : k_about_no_inputs;

  ArtefactBuilder builder("inverse_dynamics", std::string(k_about) + about_inputs, mechanics);
  builder.result_type("InverseDynamics");
  builder.artefact().takes_accelerations = true;
  std::vector<Field> fields{{"missing", "generalized forces along the speeds", {n}, ids(missing)}};
  if (drives) fields.push_back({"reached", "accelerations that the inputs make", {n}, ids(drives->accelerations)});
  builder.fields("", "", "", std::move(fields));
  if (drives) add_inputs(builder, mechanics, *drives);
  if (mechanics.dynamics.l() > 0) builder.with_solution_status();
  if (drives) {
    emit::StatusNodes& status = builder.artefact().status;
    ir::Graph& graph = mechanics.graph;
    builder.with_singular_metric(drives->singular_mass_matrix);
    const ir::Expr dependent(graph, status.dependent_constraints);
    status.dependent_constraints = ir::any(graph, {dependent, drives->dependent_constraints}).id();
  }
  std::vector<Artefact> result;
  result.push_back(builder.finish(steps));
  return result;
}

}  // namespace gaussgen
