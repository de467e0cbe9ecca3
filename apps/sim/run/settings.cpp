#include "sim/run/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/assignments.hpp"
#include "cli/overrides.hpp"
#include "cli/usage_error.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

void override_counts(const RunOptions& options, Scene& scene) {
  for (const auto& [name, count] : cli::parse_counts(options.counts)) {
    const auto is_it = [&, wanted = name](const GivenCount& given) { return given.name.text == wanted; };
    auto& counts = scene.counts;
    counts.erase(std::remove_if(counts.begin(), counts.end(), is_it), counts.end());
    counts.push_back({{name, {}}, count});
  }
}

void override_by(const RunOptions& options, Scene& scene) {
  override_counts(options, scene);
  if (!options.effects.empty()) scene.effects.clear();
  for (const std::string& word : options.effects) scene.effects.push_back({word, {}});
  const auto word = [](const std::string& text, std::optional<Word>& to) {
    if (!text.empty()) to = Word{text, {}};
  };
  word(options.method, scene.method);
  word(options.number, scene.number);
  word(options.projection, scene.projection);
  word(options.strategy, scene.strategy);
  word(options.engine, scene.engine);
  word(options.code, scene.code);
  const auto value = [](const char* option, const std::string& text, std::optional<gaussgen::model::Ast>& to) {
    if (text.empty()) return;
    to = cli::parse_value(option, text);
    to->text = text;
  };
  value("--start", options.start, scene.start);
  value("--duration", options.duration, scene.duration);
  value("--every", options.every, scene.every);
  if (!options.every.empty()) scene.samples.reset();
  if (options.samples) scene.samples = options.samples, scene.every.reset();
  const auto number = [&](const char* key, const std::optional<double>& given, std::optional<double>& to) {
    if (!given) return false;
    to = given;
    scene.places.erase(key);
    return true;
  };
  if (number("tolerance", options.tolerance, scene.tolerance)) scene.error.reset();
  if (number("step", options.step, scene.step)) scene.error.reset();
  number("longest_step", options.longest_step, scene.longest_step);
  if (number("error", options.error, scene.error)) scene.tolerance.reset(), scene.step.reset();
  if (!options.outputs.empty()) scene.outputs.clear();
  for (const std::string& name : options.outputs) scene.outputs.push_back({name, {}});
}

}  // namespace

EngineChoice engine_choice(const Scene& scene) {
  if (!scene.engine || scene.engine->text == "auto") return EngineChoice::automatic;
  return scene.engine->text == "compiled" ? EngineChoice::compiled : EngineChoice::interpreted;
}

void apply(const RunOptions& options, Scene& scene, Request& request) {
  override_by(options, scene);
  if (!chooses_method(scene)) request.also = find_method(scene.method->text)->takes;
}

namespace {

Request request_of(const RunOptions& options) {
  Request request{options.file, options.sets, {}, options.messages};
  request.instance = options.instance;
  return request;
}

std::optional<PreparedModel> prepare_form_or_scene(const RunOptions& options, Request request, int& code) {
  request.leaves_large_series_out = true;
  const auto change = [&](Scene& scene) {
    apply(options, scene, request);
    request.leaves_series_out = engine_choice(scene) == EngineChoice::interpreted;
    if (scene.error && chooses_method(scene)) request.where_possible = {"jacobian"};
  };
  const EndsAtOnce while_it_derives(options.messages);
  return prepare(request, change, code);
}

}  // namespace

std::optional<PreparedModel> prepare_run(const RunOptions& options, int& code,
                                         std::optional<gaussgen::support::Source> text) {
  Request request = request_of(options);
  request.text = std::move(text);
  return prepare_form_or_scene(options, std::move(request), code);
}

std::optional<PreparedModel> prepare_instance(const RunOptions& options, const std::string& instance,
                                              const gaussgen::support::Source& text, AmongInstances& among, int& code) {
  Request request = request_of(options);
  request.text = text;
  request.instance = instance;
  request.among = &among;
  return prepare_form_or_scene(options, std::move(request), code);
}

std::optional<PreparedModel> prepare_form(const RunOptions& options, const std::string& form) {
  Request request = request_of(options);
  request.messages.is_silent = true;
  request.form = form;
  int ignored = 0;
  return prepare_form_or_scene(options, std::move(request), ignored);
}

}  // namespace gausssim
