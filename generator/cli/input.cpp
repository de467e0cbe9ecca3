#include "cli/input.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/messages.hpp"
#include "cli/overrides.hpp"
#include "cli/usage_error.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

namespace {

std::string words_of_options(const Options& options) {
  std::string words;
  for (const auto& [name, count] : options.pipeline.choices.counts) words += fmt::format(" --count {}={}", name, count);
  if (!options.pipeline.choices.effects.empty())
    words += fmt::format(" --effects={}", fmt::join(options.pipeline.choices.effects, ","));
  if (!options.instance.empty()) words += " --instance " + options.instance;
  return words;
}

model::GivenEffects words_of(const std::vector<PlacedWord>& placed) {
  model::GivenEffects words;
  for (const PlacedWord& word : placed) words.push_back(word.text);
  return words;
}

/// Options have precedence.
void take(const SceneChoice& scene, Input& input) {
  PipelineOptions& pipeline = input.options.pipeline;
  pipeline.chosen_by = std::filesystem::path(input.options.model).filename().string() + words_of_options(input.options);
  pipeline.name = scene.name;
  pipeline.choices.counts.insert(scene.counts.begin(), scene.counts.end());
  input.are_effects_of_options = !pipeline.choices.effects.empty();
  if (!input.are_effects_of_options) {
    pipeline.choices.effects = words_of(scene.effects);
    for (const PlacedWord& word : scene.effects) input.places.push_back(word.span);
  }
  pipeline.adjust = [values = scene.values](model::Model& model) { give_values(values, model); };
  input.options.model = scene.model;
  input.choice = scene;
}

/// The scene as the instance that is asked for.
SceneChoice chosen(const SceneChoice& scene, const Options& options) {
  if (options.instance.empty()) return scene;
  if (const InstanceOfScene* const one = find_instance(scene, options.instance)) return as_instance(scene, *one);
  std::vector<std::string> names;
  for (const InstanceOfScene& one : scene.instances) names.push_back(one.name);
  const std::string near = support::did_you_mean(options.instance, names);
  throw UsageError(fmt::format("--instance: '{}' has no instance{}", options.model,
                               names.empty()
                                   ? "s"
                                   : fmt::format(" '{}'; {}", options.instance,
                                                 near.empty() ? "there are " + support::joined_first(names) : near)));
}

/// What is said of an option is said of the value.
std::string without_option(const std::string& text) {
  const std::size_t colon = text.rfind("--set", 0) == 0 ? text.find(": ") : std::string::npos;
  return colon == std::string::npos ? text : text.substr(colon + 2);
}

void refuse(const SceneValue& value, const UsageError& error, support::Diagnostics& found) {
  const auto& findings = error.findings();
  if (findings.empty())
    found.error(support::code::k_wrong_reference, value.span, without_option(error.what()));
  else
    found.error(findings.front().code, value.span, findings.front().message, findings.front().hint);
}

/// By the values of all parameters.
void check_values(const Overrides& overrides, const std::vector<SceneValue>& values, support::Diagnostics& found) {
  try {
    overrides.check();
  } catch (const UsageError& error) {
    for (const SceneValue& value : values) {
      if (std::string(error.what()).rfind("--set " + value.name + ": ", 0) == 0) refuse(value, error, found);
    }
  }
}

}  // namespace

void give_values(const std::vector<SceneValue>& values, model::Model& to) {
  Overrides overrides(to);
  support::Diagnostics found;
  for (const SceneValue& value : values) {
    if (absent_effect_of(value.name, to) != nullptr) continue;
    const std::string option = "--set " + value.name;
    try {
      overrides.set(option, value.name, parse_value(option, value.text));
    } catch (const UsageError& error) {
      refuse(value, error, found);
    }
  }
  if (!found.has_errors()) check_values(overrides, values, found);
  if (found.has_errors()) throw WrongScene(std::move(found));
}

std::optional<Input> read_input(const Options& options, int& code) {
  const ReadingGuard guard(options.messages);
  Input input{options, read_source(options.model)};
  if (options.model == "-" || !is_scene(input.source)) {
    if (!options.instance.empty())
      throw UsageError(fmt::format("--instance: '{}' is a model, and scenes have instances", options.model));
    return input;
  }
  support::Diagnostics diagnostics;
  const auto scene = read_scene_choice(input.source, diagnostics);
  code = report(diagnostics, input.source, options.messages);
  if (!scene) return std::nullopt;
  input.scene = std::move(input.source);
  take(chosen(*scene, options), input);
  input.source = read_source(scene->model);
  return input;
}

}  // namespace gaussgen::cli
