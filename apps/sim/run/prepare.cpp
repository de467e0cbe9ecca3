#include "sim/run/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "cli/assignments.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/overrides.hpp"
#include "cli/usage_error.hpp"
#include "ir/graph.hpp"
#include "mechanics.hpp"
#include "model/evaluate.hpp"
#include "model/impossible.hpp"
#include "pipeline.hpp"
#include "sim/model/layout.hpp"
#include "sim/run/jumps.hpp"
#include "sim/scene/read_scene.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
using gaussgen::support::Diagnostics;
using gaussgen::support::Source;

/// What is wrong with a scene shows when its model is read; there is no use in going on.
struct BadScene {};

/// Where words on the command line stand for those of a scene.
std::string without_option(const std::string& text) {
  const bool has_option = text.rfind("--set", 0) == 0;
  const std::size_t colon = has_option ? text.find(": ") : std::string::npos;
  return colon == std::string::npos ? text : text.substr(colon + 2);
}

class SceneValues {
 public:
  SceneValues(const Scene& scene, Diagnostics& diagnostics) : scene_(scene), diagnostics_(diagnostics) {}

  void apply(model::Model& to) {
    using model::SymbolKind;
    cli::Overrides overrides(to);
    for (const Given& given : scene_.parameters) set(overrides, to, given, SymbolKind::parameter, "parameter");
    for (const Given& given : scene_.inputs) set(overrides, to, given, SymbolKind::input, "input");
    for (const Given& given : scene_.initial) set_initial(overrides, to, given);
    if (diagnostics_.has_errors()) throw BadScene{};
    try {
      overrides.check();
    } catch (const cli::UsageError& error) {
      diagnostics_.error(code::k_undefined_value, scene_.model.span, without_option(error.what()));
      throw BadScene{};
    }
  }

 private:
  void set(cli::Overrides& overrides, const model::Model& in, const Given& given, model::SymbolKind kind,
           const char* what) {
    const auto symbol = in.symbols.find(given.name);
    if (symbol != in.symbols.end() && symbol->second.kind != kind) {
      diagnostics_.error(code::k_wrong_reference, given.span,
                         fmt::format("'{}' is no {} of the model", given.name, what));
      return;
    }
    const bool is_known_input = kind == model::SymbolKind::input && symbol != in.symbols.end();
    give(overrides, given, is_known_input ? k_of_inputs : "");
  }

  void set_initial(cli::Overrides& overrides, const model::Model& in, const Given& given) {
    const auto symbol = in.symbols.find(given.name);
    const bool is_other = symbol != in.symbols.end() && (symbol->second.kind == model::SymbolKind::parameter ||
                                                         symbol->second.kind == model::SymbolKind::input);
    if (!is_other) return give(overrides, given);
    const bool is_input = symbol->second.kind == model::SymbolKind::input;
    diagnostics_.error(code::k_wrong_reference, given.span, fmt::format("'{}' has no initial value", given.name),
                       fmt::format("it belongs under '{}'", is_input ? "inputs" : "parameters"));
  }

  void give(cli::Overrides& overrides, const Given& given, const char* hint = "") {
    try {
      overrides.set("--set " + given.name, given.name, given.value);
    } catch (const cli::UsageError& error) {
      diagnostics_.error(code::k_wrong_reference, given.span, without_option(error.what()), hint);
    }
  }

  static constexpr const char* k_of_inputs =
      "an input has one value during a run; write what changes with t or the motion into the force of the model, in "
      "place of the input, as F*sin(w*t)";

  const Scene& scene_;
  Diagnostics& diagnostics_;
};

/// The values of durations and times, which may contain parameters.
class SpanReader {
 public:
  SpanReader(const Scene& scene, const model::Values& values, Diagnostics& diagnostics)
      : scene_(scene), values_(values), diagnostics_(diagnostics) {}

  Span read() {
    Span span;
    span.start = value(scene_.start, "start", 0, false);
    span.duration = value(scene_.duration, "duration", span.duration, true);
    if (scene_.samples) span.samples = *scene_.samples;
    if (scene_.every) take_every(span);
    // Times of samples are to be told from each other.
    const double between = span.duration / static_cast<double>(span.samples - 1);
    if (scene_.start && !diagnostics_.has_errors() && !(span.start + between > span.start))
      refuse(*scene_.start, "start", fmt::format("in double, {:.6g} s later is the same time", between));
    return span;
  }

 private:
  void take_every(Span& span) {
    const double count = std::floor(span.duration / value(scene_.every, "every", span.duration, true) * (1 + 1e-12));
    constexpr double k_most = 1e8;
    if (count >= 1 && count < k_most) {
      span.samples = static_cast<long>(count) + 1;
      // Rows are where they are asked for, and the run ends with the last one.
      const double end = count * value(scene_.every, "every", span.duration, true);
      if (end < span.duration * (1 - 1e-12)) span.duration = end;
    } else if (!diagnostics_.has_errors()) {
      refuse(*scene_.every, "every",
             fmt::format("this makes {} samples; there may be from 2 to {}", count + 1, k_most));
    }
  }

  double value(const std::optional<model::Ast>& ast, const char* key, double otherwise, bool is_positive) {
    if (!ast) return otherwise;
    const auto found = model::value_of(*ast, values_);
    if (found && std::isfinite(*found) && (!is_positive || *found > 0)) return *found;
    refuse(*ast, key, fmt::format("'{}' must be a number{}", key, is_positive ? " above 0" : ""),
           found ? "" : "it may be made of numbers, pi and parameters of the model");
    return otherwise;
  }

  /// Options have no place in the file.
  void refuse(const model::Ast& ast, const char* key, const std::string& message, const std::string& hint = "") {
    if (!ast.text.empty())
      throw cli::UsageError(fmt::format("--{} {}: {}{}{}", key, ast.text, message, hint.empty() ? "" : "; ", hint));
    diagnostics_.error(code::k_out_of_range, ast.span, message, hint);
  }

  const Scene& scene_;
  const model::Values& values_;
  Diagnostics& diagnostics_;
};

/// A model beside the file that is not there, if its name is near; else where it was looked for.
std::string hint_for(const std::string& missing) {
  const std::filesystem::path path(missing);
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(path.has_parent_path() ? path.parent_path() : ".", error))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().filename().string());
  const std::string near = gaussgen::support::did_you_mean(path.filename().string(), names);
  return near.empty() ? "paths begin at the folder of the scene" : near;
}

/// Masses and inertias that no body has, by other values than those of the model's file, which are looked at with it.
void check_bodies(const Scene& scene, const std::vector<std::string>& sets, const model::Model& read,
                  Diagnostics& diagnostics) {
  if (scene.parameters.empty() && sets.empty()) return;
  for (const auto& found : model::impossible_bodies(read)) {
    if (found.severity != gaussgen::support::Severity::error) continue;
    if (scene.parameters.empty()) throw cli::UsageError("--set: " + found.message);
    diagnostics.error(found.code, scene.parameters.front().span, found.message, found.hint);
  }
}

std::string beside(const std::string& file, const std::string& named) {
  const std::filesystem::path path(named);
  return path.is_absolute() ? named : (std::filesystem::path(file).parent_path() / path).string();
}

/// The scene with another description of its motion.
void take_form(const std::string& name, Scene& scene) {
  const auto form =
      std::find_if(scene.forms.begin(), scene.forms.end(), [&](const GivenForm& one) { return one.name.text == name; });
  if (form == scene.forms.end()) return;
  const auto add = [&](const std::vector<Given>& more, std::vector<Given>& all) {
    if (form->model) all.clear();
    all.insert(all.end(), more.begin(), more.end());
  };
  add(form->initial, scene.initial);
  if (!form->parameters.empty()) add(form->parameters, scene.parameters);
  if (form->model) scene.model = *form->model;
  if (form->strategy) scene.strategy = form->strategy;
}

/// Closed forms are of columns, over time and parameters.
void check_exact(const Scene& scene, const Columns& columns, model::Values values, Diagnostics& diagnostics) {
  values["t"] = scene.exact.empty() ? 0 : 1;
  for (const Given& form : scene.exact) {
    const bool is_column = std::any_of(columns.columns.begin(), columns.columns.end(),
                                       [&](const Column& column) { return column.name == form.name; });
    if (!is_column)
      diagnostics.error(code::k_wrong_reference, form.span, fmt::format("'{}' is no column of the table", form.name),
                        "'outputs' names the columns; a closed form is of one of them");
    if (!model::is_broken(form.value) && !model::value_of(form.value, values))
      diagnostics.error(code::k_wrong_reference, form.value.span,
                        "a closed form is made of t, pi, numbers, parameters and functions of one argument or atan2");
  }
}

/// Not the start, nor inputs.
bool set_parameters_alone(const std::vector<std::string>& sets, const model::Model& read) {
  return std::all_of(sets.begin(), sets.end(), [&](const std::string& set) {
    const std::string name = set.substr(0, set.find('='));
    return std::any_of(read.parameters.begin(), read.parameters.end(),
                       [&](const model::Parameter& one) { return one.name.text == name; });
  });
}

/// Closed forms of the model's file: of its own initial state, at a time that begins with 0, and what the scene says itself counts more.
void take_exact_of_model(const std::vector<model::ClosedForm>& of_model, const Columns& columns, const Span& span,
                         model::Values values, Scene& scene) {
  if (!scene.initial.empty() || !scene.inputs.empty() || span.start != 0) return;
  values["t"] = 1;
  const auto has_name = [](const std::string& name) { return [&](const auto& one) { return one.name == name; }; };
  for (const model::ClosedForm& form : of_model) {
    const auto is_it = has_name(form.name.text);
    const bool is_column = std::any_of(columns.columns.begin(), columns.columns.end(), is_it);
    const bool is_said = std::any_of(scene.exact.begin(), scene.exact.end(), is_it);
    if (is_column && !is_said && model::value_of(form.value, values))
      scene.exact.push_back({form.name.text, form.value, form.name.span});
  }
}

/// Of the equations alone: what everything costs that calls them.
int operations_of_rates(const gaussgen::PipelineResult& compiled) {
  for (const auto& output : compiled.outputs) {
    if (output.output == "rhs") return output.operations;
  }
  return 0;
}

std::array<double, 3> gravity_of(const model::Model& read, const Span& span, model::Values values) {
  std::array<double, 3> sum{};
  values["t"] = span.start;
  for (const model::Force& force : read.forces) {
    const auto* const uniform = std::get_if<model::UniformField>(&force.law);
    for (std::size_t i = 0; uniform != nullptr && i < 3; ++i)
      sum[i] += model::value_of(uniform->field[i], values).value_or(0);
  }
  return sum;
}

gaussgen::Strategy strategy_of(const Scene& scene) {
  using gaussgen::Strategy;
  for (const Strategy one : {Strategy::tree, Strategy::metric, Strategy::multipliers}) {
    if (scene.strategy && gaussgen::name_of(one) == scene.strategy->text) return one;
  }
  return Strategy::automatic;
}

/// Whoever asks for what is not there is told of all that could be.
std::optional<gaussgen::PipelineResult> with_all_outputs(Source& source, gaussgen::PipelineOptions options) {
  options.plain = true;
  options.where_possible = sampled_outputs();
  Diagnostics ignored;
  try {
    return compile(source, options, ignored, nullptr);
  } catch (const gaussgen::ir::TooManyNodes&) {
    return std::nullopt;
  }
}

/// Nobody has asked for what is empty, where outputs were chosen for the user.
Diagnostics without_empty_outputs(const Diagnostics& all) {
  Diagnostics kept;
  for (const auto& found : all.all()) {
    if (found.code != std::string(code::k_empty_output)) kept.add(found);
  }
  return kept;
}

}  // namespace

std::optional<PreparedModel> prepare(const Request& request, const std::function<void(Scene&)>& change,
                                     int& exit_code) {
  const auto begin = std::chrono::steady_clock::now();
  PreparedModel result;
  Source scene_source = cli::read_source(request.file);
  Diagnostics in_scene;
  const bool has_scene = is_scene(scene_source);
  if (has_scene) {
    const std::optional<Scene> scene = read_scene(scene_source, in_scene);
    exit_code = cli::report(in_scene, scene_source, request.messages);
    if (!scene || exit_code != cli::k_ok) return std::nullopt;
    result.scene = *scene;
  }
  if (!request.form.empty()) take_form(request.form, result.scene);
  change(result.scene);
  result.model_file = has_scene ? beside(request.file, result.scene.model.text) : request.file;
  if (has_scene && !std::filesystem::exists(result.model_file)) {
    in_scene.error(code::k_submodel_file, result.scene.model.span,
                   fmt::format("there is no file '{}'", result.scene.model.text), hint_for(result.model_file));
    exit_code = cli::report(in_scene, scene_source, request.messages);
    return std::nullopt;
  }
  Source source = has_scene ? cli::read_source(result.model_file) : scene_source;

  gaussgen::PipelineOptions options;
  options.fold = result.scene.code && result.scene.code->text == "folded";
  options.plain = result.scene.code && result.scene.code->text == "expanded";
  options.where_possible = request.where_possible;
  options.counts = result.scene.counts;
  options.strategy = strategy_of(result.scene);
  options.outputs = generator_outputs(result.scene.outputs);
  for (const char* const output : {"initial_state", "project", "energy", "residuals"})
    options.outputs.push_back(output);
  options.outputs.insert(options.outputs.end(), request.also.begin(), request.also.end());
  const bool uses_gains = result.scene.projection && result.scene.projection->text == "gains";
  if (uses_gains) options.where_possible.push_back("mass_matrix");
  const auto& welcome = options.where_possible;
  result.wants_gains = std::find(welcome.begin(), welcome.end(), "mass_matrix") != welcome.end();
  const std::string method = result.scene.method ? result.scene.method->text : "auto";
  if (method == "taylor") options.outputs.push_back("taylor");
  if (method == "auto") options.where_possible.push_back("taylor");
  Diagnostics in_values;
  model::Values parameters;
  std::vector<model::ClosedForm> closed_forms;
  options.adjust = [&](model::Model& read) {
    SceneValues(result.scene, in_values).apply(read);
    cli::apply_overrides(request.sets, read);
    if (request.adjust) request.adjust(result.scene, read, in_values);
    parameters = model::parameter_values(read);
    check_bodies(result.scene, request.sets, read, in_values);
    for (const model::Parameter& one : read.parameters) result.parameters.emplace_back(one.name.text, one.value);
    result.edge = function_with_edge(read);
    if (set_parameters_alone(request.sets, read)) closed_forms = read.exact;
    result.span = SpanReader(result.scene, parameters, in_values).read();
    if (in_values.has_errors()) throw BadScene{};
    result.gravity = gravity_of(read, result.span, parameters);
  };
  Diagnostics found;
  std::optional<gaussgen::PipelineResult> compiled;
  try {
    compiled = compile(source, options, found, nullptr);
  } catch (const BadScene&) {
    exit_code = cli::report(in_values, scene_source, request.messages);
    return std::nullopt;
  }
  exit_code = cli::report(without_empty_outputs(found), source, request.messages);
  if (!compiled || exit_code != cli::k_ok) return std::nullopt;
  if (find_function(compiled->tree, "rhs") == nullptr) {
    exit_code = cli::fail(
        fmt::format("nothing moves in '{}' by itself: there is no motion to be found", compiled->unit.model_name),
        cli::k_motion_stopped, request.messages);
    return std::nullopt;
  }
  result.operations = operations_of_rates(*compiled);
  result.model = {std::move(compiled->tree), std::move(compiled->unit)};
  const auto everything = [&] {
    auto all = with_all_outputs(source, options);
    return all ? Described{std::move(all->tree), std::move(all->unit)} : result.model;
  };
  result.columns = choose_columns(result.model, result.scene.outputs, in_values, everything);
  check_exact(result.scene, result.columns, parameters, in_values);
  take_exact_of_model(closed_forms, result.columns, result.span, parameters, result.scene);
  // Those of the command line have no place in the file.
  const bool are_options = !result.scene.outputs.empty() && result.scene.outputs.front().span.end == 0;
  if (in_values.has_errors() && are_options)
    throw cli::UsageError("--outputs: " + in_values.all().front().message + "; " + in_values.all().front().hint);
  exit_code = cli::report(in_values, scene_source, request.messages);
  if (exit_code != cli::k_ok) return std::nullopt;
  result.generate_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace gausssim
