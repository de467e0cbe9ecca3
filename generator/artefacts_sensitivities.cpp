#include <algorithm>

#include "artefact_builder.hpp"
#include "derivatives.hpp"
#include "emit/identifiers.hpp"
#include "ir/cost.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

using emit::Artefact;
using emit::Field;
using strategy::Steps;
using strategy::Vector;

namespace {

/// Derivatives of everything by one parameter after another.
struct Candidate {
  std::vector<Vector> rates, multipliers, held;
  Steps steps;
  int operations = 0;
};

std::vector<Variable> chosen_parameters(const Mechanics& mechanics) {
  std::vector<Variable> variables;
  const std::vector<model::Parameter>& parameters = mechanics.model.parameters;
  for (const model::Name& name : mechanics.model.sensitivities) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name.text == name.text) variables.push_back({mechanics.symbols.parameters[i], name.text});
    }
  }
  return variables;
}

Candidate derived(Mechanics& mechanics, const std::vector<Variable>& variables, DerivativeMethod method) {
  Candidate result;
  std::vector<emit::NodeId> roots;
  const auto keep = [&](const Vector& values, std::vector<Vector>& list) {
    for (const ir::Expr value : values) roots.push_back(value.id());
    list.push_back(values);
  };
  Derivatives derivatives(mechanics, variables, method, result.steps);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    derivatives.by(k);
    keep(derivatives(state_rates(mechanics)), result.rates);
    keep(derivatives(mechanics.solution.multipliers), result.multipliers);
    keep(derivatives(mechanics.held_reactions), result.held);
  }
  result.operations = ir::operations(mechanics.graph, roots);
  return result;
}

std::string held_names(const Mechanics& mechanics) {
  std::vector<std::string> names;
  for (const auto& held : mechanics.symbols.held) names.push_back(held.name);
  return support::joined(names);
}

void add_field(const char* name, const std::string& about, const Vector& values, std::vector<Field>& fields) {
  if (!values.empty()) fields.push_back({name, about, {static_cast<int>(values.size())}, ids(values)});
}

}  // namespace

std::vector<Artefact> sensitivities_artefact(Mechanics& mechanics) {
  const std::vector<Variable> variables = chosen_parameters(mechanics);
  if (variables.empty() || mechanics.options.fold) return {};
  Candidate found = derived(mechanics, variables, DerivativeMethod::implicit);
  Candidate through = derived(mechanics, variables, DerivativeMethod::forward);
  if (through.operations < found.operations) found = std::move(through);

  ArtefactBuilder builder(
      "sensitivities",
      "Derivatives by parameters, where the state is the same: of what rhs fills, of multipliers in "
      "the order of the constraints, and of the generalized reactions of held coordinates. What "
      "follows from a parameter by a formula counts.",
      mechanics);
  builder.result_type("Sensitivities");
  const std::string of_held = "of the generalized reactions of " + held_names(mechanics);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    std::vector<Field> fields;
    add_field("rhs", "of what rhs fills, in the order of Derivative", found.rates[k], fields);
    add_field("multipliers", "of the multipliers, in the order of the constraints", found.multipliers[k], fields);
    add_field("held", of_held, found.held[k], fields);
    if (!fields.empty())
      builder.fields(variables[k].name, "By" + emit::pascal_case(variables[k].name), "by " + variables[k].name,
                     std::move(fields));
  }
  builder.with_solution_status();
  std::vector<Artefact> result;
  result.push_back(builder.finish(found.steps));
  return result;
}

}  // namespace gaussgen
