#include "output_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "artefact_builder.hpp"
#include "artefacts.hpp"
#include "support/error_codes.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

namespace {

struct Absence {
  const char* why;
  const char* hint;
};

/// As `build_artefact` decides.
Absence absence_of(const std::string& output, const model::Model& model) {
  if (output == "reactions" || output == "reaction_forces") {
    return {"it has no constraint and no held coordinate",
            "what joints transmit is 'joint_reactions'; else remove it from the outputs"};
  }
  if (output == "joint_reactions") {
    return {"it has no joints", "forces of constraints are in 'reaction_forces'; else remove it from the outputs"};
  }
  if (output == "residuals") {
    return {"it has no constraint and no quaternion", "there is nothing to satisfy: remove it from the outputs"};
  }
  if (output == "quantities") {
    return {"it names none", "write what you want to know under 'quantities', or remove it from the outputs"};
  }
  if (output == "compulsion") {
    return {"a body in it has no mass or no inertia, which Z divides by",
            "give it some, or remove it from the outputs; what has no inertia stands under 'particles'"};
  }
  if (output == "sensitivities") {
    return {"no parameter is named for it, or --fold makes them numbers",
            "name parameters under 'sensitivities', or by --sensitivities; or remove it from the outputs"};
  }
  if (output == "taylor") {
    return {
        "it has no free coordinate, or its constraints follow from each other wherever they hold, and that way has no "
        "series",
        "leave out the constraints that follow from others, or remove it from the outputs"};
  }
  if (output == "mobility") {
    return {
        "it has no constraints that may follow from each other, or too many speeds and constraints for a solution "
        "of any rank",
        "remove it from the outputs; 'gauss-gen --check' says what the constraints leave"};
  }
  if (output == "guards")
    return {"it has no contact, dry friction or link that breaks",
            "nothing ends its regime: remove it from the outputs"};
  if (output == "load_system") {
    return {"all reactions that its guards judge are unique, or it has none",
            "nothing is shared in this regime: remove it from the outputs"};
  }
  if (output == "impact_system" && model.contacts.size() + model.frictions.size() == 0)
    return {"it has no contact and no dry friction", "nothing hits anything: remove it from the outputs"};
  if (output == "impact_system") {
    return {"it is of the regime in which all contacts are open and all friction is free",
            "--regime ground is that one; else remove it from the outputs"};
  }
  if (output == "inverse_dynamics" && model::has_reactions_in_forces(model)) {
    return {"a force in it depends on reactions, which would be others of accelerations that are given",
            "write the force without them, or remove it from the outputs"};
  }
  return {"no coordinate is free, so it has no state", "remove it from the outputs"};
}

bool has(const emit::Unit& unit, const std::string& output) {
  return std::any_of(unit.artefacts.begin(), unit.artefacts.end(),
                     [&](const emit::Artefact& artefact) { return artefact.name == output; });
}

/// Those of the command line stand nowhere in the file: the model itself is meant.
std::vector<model::Name> asked_for(const model::Model& model, const PipelineOptions& options) {
  if (options.outputs.empty()) {
    std::vector<model::Name> names = model.outputs;
    // Parameters are named for the sake of it.
    if (!model.sensitivities.empty()) names.push_back({"sensitivities", model.sensitivities.front().span});
    return names;
  }
  std::vector<model::Name> names;
  for (const std::string& output : options.outputs) names.push_back({output, model.name.span});
  return names;
}

void report_absent(const model::Name& name, const model::Model& model, support::Diagnostics& diagnostics) {
  const Absence absence = absence_of(name.text, model);
  diagnostics.warning(
      support::code::k_empty_output, name.span,
      fmt::format("the output '{}' is left out, as this model has nothing for it: {}", name.text, absence.why),
      absence.hint);
}

/// They are those of the regular way, in which rows that follow from others are divided by what is zero: with other parameters these may follow no longer.
void check_sensitivities(const model::Name& name, Mechanics& mechanics, support::Diagnostics& diagnostics) {
  const std::size_t l = mechanics.dynamics.l();
  if (!has_general_way(mechanics) || usual_rank(mechanics) == l) return;
  diagnostics.warning(
      support::code::k_empty_output, name.span,
      fmt::format("the output '{}' has status dependent_constraints in every state: {} constraints "
                  "have rank {} wherever they hold",
                  name.text, l, usual_rank(mechanics)),
      "differentiate rhs by gauss::Dual numbers or differences, or leave out the constraints that follow from "
      "others");
}

template <class Has>
void check_each(Mechanics& mechanics, const PipelineOptions& options, support::Diagnostics& diagnostics,
                const Has& has_output) {
  std::set<std::string> seen;
  for (const model::Name& name : asked_for(mechanics.model, options)) {
    if (!seen.insert(name.text).second) continue;
    if (!has_output(name.text)) {
      report_absent(name, mechanics.model, diagnostics);
    } else if (name.text == "sensitivities") {
      check_sensitivities(name, mechanics, diagnostics);
    }
  }
}

}  // namespace

void check_outputs(const emit::Unit& unit, Mechanics& mechanics, const PipelineOptions& options,
                   support::Diagnostics& diagnostics) {
  check_each(mechanics, options, diagnostics, [&](const std::string& output) { return has(unit, output); });
}

void check_outputs(Mechanics& mechanics, const PipelineOptions& options, support::Diagnostics& diagnostics) {
  check_each(mechanics, options, diagnostics, [&](const std::string& output) { return has_output(output, mechanics); });
}

}  // namespace gaussgen
