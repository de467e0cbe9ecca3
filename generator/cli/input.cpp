#include "cli/input.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/messages.hpp"
#include "cli/overrides.hpp"
#include "scene_choice.hpp"

namespace gaussgen::cli {

namespace {

std::string words_of_options(const Options& options) {
  std::string words;
  for (const auto& [name, count] : options.pipeline.choices.counts) words += fmt::format(" --count {}={}", name, count);
  if (!options.pipeline.choices.effects.empty())
    words += fmt::format(" --effects={}", fmt::join(options.pipeline.choices.effects, ","));
  return words;
}

/// Options have precedence.
void take(const SceneChoice& scene, Input& input) {
  PipelineOptions& pipeline = input.options.pipeline;
  pipeline.chosen_by = std::filesystem::path(input.options.model).filename().string() + words_of_options(input.options);
  pipeline.name = scene.name;
  pipeline.choices.counts.insert(scene.counts.begin(), scene.counts.end());
  if (pipeline.choices.effects.empty()) {
    pipeline.choices.effects = scene.effects;
    input.places = scene.places;
  }
  pipeline.adjust = [values = scene.values](model::Model& model) {
    std::vector<std::string> assignments;
    for (const auto& [name, value] : values) assignments.push_back(name + "=" + value);
    apply_overrides(assignments, model);
  };
  input.options.model = scene.model;
}

}  // namespace

std::optional<Input> read_input(const Options& options, int& code) {
  const ReadingGuard guard(options.messages);
  Input input{options, read_source(options.model)};
  if (options.model == "-" || !is_scene(input.source)) return input;
  support::Diagnostics diagnostics;
  const auto scene = read_scene_choice(input.source, diagnostics);
  code = report(diagnostics, input.source, options.messages);
  if (!scene) return std::nullopt;
  input.scene = std::move(input.source);
  take(*scene, input);
  input.source = read_source(scene->model);
  return input;
}

}  // namespace gaussgen::cli
