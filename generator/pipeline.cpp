#include "pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "artefact_builder.hpp"
#include "artefacts.hpp"
#include "assembly.hpp"
#include "chart_check.hpp"
#include "dumps.hpp"
#include "early_check.hpp"
#include "general_start.hpp"
#include "initial_check.hpp"
#include "model/fold_check.hpp"
#include "output_check.hpp"
#include "paper.hpp"
#include "passes/cancellation.hpp"
#include "point_check.hpp"
#include "read_model.hpp"
#include "sensitivities.hpp"
#include "series_check.hpp"
#include "strategy/projection.hpp"
#include "structure_check.hpp"
#include "support/error_codes.hpp"
#include "unit.hpp"
#include "usual_rank.hpp"
#include "value_check.hpp"

namespace gaussgen {

namespace {

const char* const k_check = "check";
const char* const k_limits = "limits";
constexpr int k_digits_of_start = 17;

/// Times stages, and shows to the observer what comes out.
class Stages {
 public:
  Stages(const StageObserver& observe, std::string last_stage)
      : observe_(observe), last_stage_(std::move(last_stage)), last_(Clock::now()) {}

  /// A stage took from the end of the one before until then.
  void took(const std::string& stage, const Milestone& end, std::size_t bytes = 0) {
    times_.push_back(
        {stage, std::chrono::duration<double, std::milli>(end.time - last_).count(), nodes_, end.nodes, bytes});
    last_ = end.time;
    nodes_ = end.nodes;
  }

  /// Until now.
  void took(const std::string& stage, const ir::Graph& graph) { took(stage, {Clock::now(), graph.size()}); }

  /// What dumps take is no part of any stage. True where nobody asks for what comes after it.
  bool show(const std::string& stage, const std::function<std::string()>& dump) {
    const auto begin = Clock::now();
    ++shown_;
    if (observe_) observe_(stage, dump);
    last_ += Clock::now() - begin;
    return stage == last_stage_;
  }

  std::vector<StageTime> times() && { return std::move(times_); }

  const std::string& under_way() const { return stage_names()[std::min(shown_, stage_names().size() - 1)]; }

 private:
  using Clock = std::chrono::steady_clock;

  const StageObserver& observe_;
  std::string last_stage_;
  Clock::time_point last_;
  std::size_t nodes_ = 0;
  std::size_t shown_ = 0;
  std::vector<StageTime> times_;
};

constexpr const char* k_start = "initial_state";

bool asks_for(const char* output, const Mechanics& mechanics, const PipelineOptions& options) {
  const std::vector<std::string> wanted = wanted_outputs(mechanics.model, options);
  return std::find(wanted.begin(), wanted.end(), output) != wanted.end();
}

bool emits_initial_state(const Mechanics& mechanics, const PipelineOptions& options) {
  return mechanics.dynamics.n() > 0 && asks_for(k_start, mechanics, options);
}

/// Modes that are asked for may be those of a regime that a motion comes to, and does not start in. Whoever names `initial_state` wants it of this one.
bool starts_elsewhere(Mechanics& mechanics, const PipelineOptions& options) {
  const auto& named = options.outputs;
  if (options.choices.regime.empty() || options.assemble ||
      std::find(named.begin(), named.end(), k_start) != named.end())
    return false;
  return !is_start_of(mechanics);
}

}  // namespace

const std::vector<std::string>& stage_names() {
  static const std::vector<std::string> k_names{"model", "kinematics", "paper", "strategy",
                                                k_check, "artefacts",  "header"};
  return k_names;
}

std::vector<std::string> rules_for_digits() {
  std::vector<std::string> names = passes::digit_rules();
  names.emplace_back(k_limits);
  return names;
}

std::vector<std::string> stages_with_dump() {
  std::vector<std::string> names = stage_names();
  names.erase(std::find(names.begin(), names.end(), k_check));
  return names;
}

namespace {

void check_strategy(const Mechanics& mechanics, support::Diagnostics& diagnostics) {
  if (mechanics.options.strategy != Strategy::tree || !mechanics.solution.is_of_metric) return;
  diagnostics.error(support::code::k_no_tree, mechanics.model.name.span,
                    fmt::format("Z cannot be minimised body by body: {}", mechanics.no_tree),
                    "leave --strategy=tree out");
}

/// What outputs would show, as far as equations of motion and reactions do: forming all of them may take a hundred times as long.
void check_unformed(Mechanics& mechanics, const PipelineOptions& options, support::Diagnostics& diagnostics) {
  check_outputs(mechanics, options, diagnostics);
  std::vector<ir::NodeId> nodes;
  for (const auto* values :
       {&mechanics.solution.accelerations, &mechanics.solution.multipliers, &mechanics.held_reactions}) {
    for (const ir::Expr value : *values) nodes.push_back(value.id());
  }
  check_range(mechanics.graph, nodes, mechanics.model.name, diagnostics);
}

/// Of a model that is right otherwise.
bool can_have(const std::string& output, Mechanics& mechanics) {
  if (!has_output(output, mechanics)) return false;
  support::Diagnostics found;
  if (output == "taylor") check_series(mechanics, found);
  return !found.has_errors();
}

std::optional<PipelineResult> compile(support::Source& source, PipelineOptions options,
                                      support::Diagnostics& diagnostics, Stages& stages) {
  std::optional<model::Model> model = read_model(source, diagnostics, options.choices);
  if (!model) return std::nullopt;
  if (options.adjust) options.adjust(*model);
  if (!options.name.empty()) model->name.text = options.name;
  stages.took("model", {std::chrono::steady_clock::now(), 0}, source.text().size());
  PipelineResult result;
  result.model_name = model->name.text;
  for (const model::Effect& effect : model->effects) {
    if (effect.acts) result.effects.push_back(effect.name.text);
  }
  result.has_units = model::has_units(*model);
  const auto up_to_here = [&] {
    result.times = std::move(stages).times();
    return result;
  };
  if (stages.show("model", [&] { return dump_model(*model, source); })) return up_to_here();

  if (!options.sensitivities.empty()) choose_sensitivities(options.sensitivities, *model, diagnostics);
  if (options.fold) model::check_fold(*model, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;

  // The emitted route: theory section 4 on the graph.
  const bool limits =
      std::find(options.as_written.begin(), options.as_written.end(), k_limits) == options.as_written.end();
  const MechanicsOptions mechanics_options{options.fold, options.strategy, options.most_nodes, limits};
  check_early(*model, mechanics_options, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  Mechanics mechanics(*model, mechanics_options);
  stages.took("kinematics", mechanics.kinematics_built);
  stages.took("strategy", mechanics.graph);
  check_strategy(mechanics, diagnostics);
  check_structure(mechanics, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const StatedStart stated = stated_start(*model, mechanics.expressions);
  if (options.assemble) {
    assemble(mechanics, *model);
  } else {
    report_found(improve_guesses(mechanics, *model), *model, diagnostics);
  }
  find_general_start(mechanics, support::Rational(0), k_digits_of_start);
  stages.took("start", mechanics.graph);
  if (stages.show("kinematics", [&] { return dump_kinematics(mechanics); })) return up_to_here();

  // The paper's route in GiNaC replaces the result where it is asked for; otherwise it is made for its dump only.
  if (options.route != Route::paper) check_choice(mechanics, diagnostics);
  if (options.route == Route::paper && !take_paper_route(mechanics, options.fold, diagnostics)) return std::nullopt;
  if (options.route == Route::paper) stages.took("paper", mechanics.graph);
  if (stages.show("paper", [&] { return dump_paper(mechanics); })) return up_to_here();
  if (stages.show("strategy", [&] { return dump_strategy(mechanics); })) return up_to_here();

  // Before all else that takes long.
  options.leaves_start_out = starts_elsewhere(mechanics, options);
  check_initial_state(mechanics,
                      {emits_initial_state(mechanics, options), options.leaves_start_out, options.assemble, &source},
                      diagnostics);
  check_points(mechanics, diagnostics);
  if (!diagnostics.has_errors()) check_chart(mechanics, diagnostics);
  if (asks_for("taylor", mechanics, options) && has_taylor(mechanics)) check_series(mechanics, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  stages.took(k_check, mechanics.graph);
  stages.show(k_check, [] { return std::string(); });

  if (options.only_check) {
    check_unformed(mechanics, options, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    result.mobility = mobility_in_words(mechanics);
    if (options.assemble) result.assembled = assembled_values(mechanics, stated);
    return up_to_here();
  }

  for (const std::string& output : options.where_possible) {
    if (options.leaves_start_out && output == k_start) continue;
    if (can_have(output, mechanics)) options.outputs.push_back(output);
  }
  emit::Unit unit = build_unit(mechanics, source, options);
  check_outputs(unit, mechanics, options, diagnostics);
  check_range(mechanics.graph, unit, model->name, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  stages.took("artefacts", mechanics.graph);
  if (stages.show("artefacts", [&] { return dump_artefacts(mechanics, unit); })) return up_to_here();

  if (options.assemble) result.assembled = assembled_values(mechanics, stated);
  emit::Header header = header_in_range(std::move(mechanics.graph), unit, model->name, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  result.header = std::move(header.text);
  result.tree = std::move(header.tree);
  result.unit = std::move(unit);
  result.source = std::move(header.source);
  result.passes = std::move(header.passes);
  result.outputs = std::move(header.outputs);
  result.chose_outputs = !options.outputs.empty() || !mechanics.model.outputs.empty();
  stages.took("passes", {header.planned, header.nodes_planned});
  stages.took("header", {std::chrono::steady_clock::now(), header.nodes}, result.header.size());
  stages.show("header", [&] { return result.header; });

  return up_to_here();
}

}  // namespace

std::optional<PipelineResult> compile(support::Source& source, const PipelineOptions& options,
                                      support::Diagnostics& diagnostics, const StageObserver& observe) {
  Stages stages(observe, options.last_stage);
  try {
    return compile(source, options, diagnostics, stages);
  } catch (const ir::TooManyNodes& error) {
    // A derivative by each of n variables, such as 'jacobian', has n^2 entries where the equations have n.
    const std::string& stage = stages.under_way();
    const char* const less = stage == "artefacts" || stage == "header" ? ", and fewer of --outputs take less" : "";
    throw ir::TooManyNodes(fmt::format("{} in the stage '{}'; --max-nodes allows more{}", error.what(), stage, less));
  }
}

}  // namespace gaussgen
