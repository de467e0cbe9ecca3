#include "unit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "artefacts.hpp"
#include "usual_rank.hpp"
#include "version.hpp"

namespace gaussgen {

namespace {

using kinematics::ConfigurationIndex;
using kinematics::FreeIndex;

class UnitBuilder {
 public:
  UnitBuilder(Mechanics& mechanics, const support::Source& source, const PipelineOptions& options)
      : mechanics_(mechanics), model_(mechanics.model), source_(source), options_(options) {}

  emit::Unit run() {
    unit_.model_name = model_.name.text;
    unit_.about = model_.about;
    unit_.name_space = options_.name_space.empty() ? "gauss::" + model_.name.text : options_.name_space;
    unit_.time = mechanics_.symbols.time;
    unit_.epsilon = mechanics_.symbols.epsilon;
    unit_.folded = options_.fold;
    unit_.part_operations = options_.part_operations;
    unit_.compiled_for = options_.compiled_for;
    unit_.optimised = !options_.plain;
    unit_.as_written = options_.as_written;
    add_parameters();
    add_inputs();
    add_state();
    add_held();
    for (const model::Constraint& constraint : model_.constraints) {
      unit_.constraints.push_back({constraint.name.text, constraint.about});
    }
    add_artefacts();
    add_provenance();
    return std::move(unit_);
  }

 private:
  void add_parameters() {
    if (options_.fold) return;
    for (std::size_t i = 0; i < model_.parameters.size(); ++i) {
      const model::Parameter& parameter = model_.parameters[i];
      unit_.parameters.push_back(
          {{mechanics_.symbols.parameters[i], parameter.name.text, parameter.unit, parameter.about},
           mechanics_.expressions(parameter.value).id(),
           parameter.is_formula});
    }
  }

  void add_inputs() {
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      const model::Input& input = model_.inputs[i];
      unit_.inputs.push_back({{mechanics_.symbols.inputs[i], input.name.text, input.unit, input.about},
                              mechanics_.expressions(input.value).id()});
    }
  }

  void add_state() {
    const kinematics::Symbols& symbols = mechanics_.symbols;
    for (const ConfigurationIndex i : symbols.configuration.indices()) {
      const auto& q = symbols.configuration[i];
      unit_.configuration.push_back({q.symbol, q.name, q.unit, q.about});
      unit_.configuration_rates.push_back(q.name + "_dot");
    }
    for (const FreeIndex i : symbols.speeds.indices()) {
      const auto& u = symbols.speeds[i];
      unit_.speeds.push_back({u.symbol, u.name, u.unit, u.about});
      const std::string unit = u.unit.empty() ? "" : u.unit + "^2";
      unit_.accelerations.push_back({u.acceleration, u.acceleration_name, unit, "rate of " + u.name});
    }
  }

  void add_held() {
    for (const auto& held : mechanics_.symbols.held) {
      const model::Coordinate& coordinate = model_.coordinates[held.model_index];
      const std::string_view law = model::words_of(*coordinate.held_at, source_);
      unit_.held.push_back({held.name, coordinate.unit, coordinate.about, std::string(law)});
    }
  }

  // In the order of output_kinds, whatever the order of the request: same functions, same bytes.
  void add_artefacts() {
    const std::vector<std::string> wanted = wanted_outputs(model_, options_);
    for (const OutputKind& kind : output_kinds()) {
      const bool is_wanted = kind.name == "rhs" || std::find(wanted.begin(), wanted.end(), kind.name) != wanted.end();
      if (!is_wanted) continue;
      for (emit::Artefact& artefact : build_artefact(kind.name, mechanics_)) {
        artefact.output = kind.name;
        unit_.artefacts.push_back(std::move(artefact));
      }
    }
    for (std::size_t mu = 0; mu < mechanics_.multipliers.size(); ++mu) {
      const std::string& name = mechanics_.dynamics.constraints[mu];
      unit_.multipliers.push_back({mechanics_.multipliers[mu], "lambda_" + name, "", ""});
    }
    for (std::size_t i = 0; i < mechanics_.start.size(); ++i) {
      const emit::Entry& now = unit_.configuration[i];
      unit_.start.push_back({mechanics_.start[i], now.name, now.unit, "before a projection"});
    }
    for (emit::Artefact& artefact : unit_.artefacts) point_to_model_lines(artefact);
  }

  // A comment about an element of the model also says where the model states it.
  void point_to_model_lines(emit::Artefact& artefact) const {
    for (emit::Group& group : artefact.groups) group.about += line_of(group.name);
    for (emit::Section& section : artefact.sections) section.comment += line_of(section.subject);
  }

  std::string line_of(const std::string& element) const {
    for (const model::Constraint& constraint : model_.constraints) {
      if (element == constraint.name.text) return located(constraint.name.span);
    }
    for (const model::Joint& joint : model_.joints) {
      if (element == joint.name.text) return located(joint.name.span);
    }
    for (const model::Coordinate& coordinate : model_.coordinates) {
      if (coordinate.held_at && element == coordinate.name.text) return located(coordinate.name.span);
    }
    return "";
  }

  std::string located(support::Span span) const { return ", model " + source_.line_text(span.begin); }

  std::string what_is_chosen() const {
    if (!options_.chosen_by.empty()) return options_.chosen_by;
    std::string text = model_.file == "<stdin>" ? std::string("-") : model_.file;
    for (const auto& [name, count] : options_.choices.counts) text += fmt::format(" --count {}={}", name, count);
    if (!options_.choices.effects.empty())
      text += fmt::format(" --effects={}", fmt::join(options_.choices.effects, ","));
    return text;
  }

  void add_provenance() {
    emit::Provenance& provenance = unit_.provenance;
    provenance.tool_version = k_version;
    provenance.model_file = model_.file;
    provenance.model_hash = model_.content_hash;
    provenance.command = "gauss-gen " + what_is_chosen();
    if (options_.choices.is_ground) provenance.command += " --regime ground";
    for (const auto& [name, mode] : options_.choices.regime) provenance.command += " --regime " + name + "=" + mode;
    if (options_.leaves_start_out)
      provenance.notes.push_back("The motion starts in another regime, so there is no initial_state.");
    if (!options_.outputs.empty()) {
      std::string list;
      for (const OutputKind& kind : output_kinds()) {
        if (std::find(options_.outputs.begin(), options_.outputs.end(), kind.name) == options_.outputs.end()) continue;
        list += (list.empty() ? "" : ",") + kind.name;
      }
      provenance.command += " --outputs=" + list;
    }
    if (!options_.sensitivities.empty())
      provenance.command += " --sensitivities=" + fmt::format("{}", fmt::join(options_.sensitivities, ","));
    if (options_.fold) provenance.command += " --fold";
    if (options_.plain) provenance.command += " --no-optimise";
    if (!options_.as_written.empty())
      provenance.command += fmt::format(" --as-written={}", fmt::join(options_.as_written, ","));
    if (options_.route == Route::paper) provenance.command += " --route=paper";
    if (options_.strategy != Strategy::automatic) provenance.command += " --strategy=" + name_of(options_.strategy);
    if (options_.part_operations != emit::k_part_operations)
      provenance.command += " --parts=" + std::to_string(options_.part_operations);
    if (!options_.compiled_for.empty()) {
      std::string types = fmt::format("{}", fmt::join(options_.compiled_for, ","));
      std::replace(types.begin(), types.end(), ' ', '-');
      provenance.command += " --split=" + types;
    }
    if (!options_.name_space.empty()) provenance.command += " --namespace=" + options_.name_space;
    provenance.strategy = mechanics_.solution.description;
    if (const std::string mobility = mobility_in_words(mechanics_);
        !mobility.empty() && has_output("mobility", mechanics_))
      provenance.notes.push_back((locked_motions(mechanics_) ? "At the initial place, as far as a search sees: "
                                                             : "Where nothing singles a state out: ") +
                                 mobility + ".");
  }

  Mechanics& mechanics_;
  const model::Model& model_;
  const support::Source& source_;
  const PipelineOptions& options_;
  emit::Unit unit_;
};

/// Parameters are named for the sake of it.
std::vector<std::string> with_sensitivities(std::vector<std::string> names, bool are_named) {
  const std::string output = "sensitivities";
  if (are_named && std::find(names.begin(), names.end(), output) == names.end()) names.push_back(output);
  return names;
}

std::vector<std::string> asked_for(const model::Model& model, const PipelineOptions& options) {
  if (!options.outputs.empty()) return with_sensitivities(options.outputs, !options.sensitivities.empty());
  std::vector<std::string> names;
  for (const model::Name& name : model.outputs) names.push_back(name.text);
  if (!names.empty()) return with_sensitivities(names, !model.sensitivities.empty());
  for (const OutputKind& kind : output_kinds()) {
    if (kind.is_usual) names.push_back(kind.name);
  }
  return with_sensitivities(names, !model.sensitivities.empty());
}

}  // namespace

std::vector<std::string> wanted_outputs(const model::Model& model, const PipelineOptions& options) {
  std::vector<std::string> names = asked_for(model, options);
  if (options.leaves_start_out) names.erase(std::remove(names.begin(), names.end(), "initial_state"), names.end());
  return names;
}

emit::Unit build_unit(Mechanics& mechanics, const support::Source& source, const PipelineOptions& options) {
  return UnitBuilder(mechanics, source, options).run();
}

}  // namespace gaussgen
