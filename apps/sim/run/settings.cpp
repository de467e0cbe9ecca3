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
  if (options.tolerance) scene.tolerance = options.tolerance, scene.error.reset();
  if (options.step) scene.step = options.step, scene.error.reset();
  if (options.longest_step) scene.longest_step = options.longest_step;
  if (options.error) scene.error = options.error, scene.tolerance.reset(), scene.step.reset();
  if (!options.outputs.empty()) scene.outputs.clear();
  for (const std::string& name : options.outputs) scene.outputs.push_back({name, {}});
}

void check_method(const Scene& scene) {
  if (chooses_method(scene)) return;
  const MethodInfo& method = *find_method(scene.method->text);
  const auto refuse = [&](const std::string& why) {
    throw cli::UsageError(fmt::format("method '{}': {}", method.name, why));
  };
  if (!method.missing.empty()) refuse(method.missing);
  const std::string number = number_name(scene);
  if (!computes_in(method, number)) refuse("it does not compute in " + number);
  if (!method.projects && scene.projection && scene.projection->text != "off")
    refuse("it does not project, so states drift off the constraints as its tolerance allows; take 'projection: off'");
}

}  // namespace

EngineChoice engine_choice(const Scene& scene) {
  if (!scene.engine || scene.engine->text == "auto") return EngineChoice::automatic;
  return scene.engine->text == "compiled" ? EngineChoice::compiled : EngineChoice::interpreted;
}

void apply(const RunOptions& options, Scene& scene, Request& request) {
  override_by(options, scene);
  check_method(scene);
  if (!chooses_method(scene)) request.also = find_method(scene.method->text)->takes;
}

std::optional<PreparedModel> prepare_run(const RunOptions& options, int& code) {
  Request request{options.file, options.sets, {}, options.messages};
  request.leaves_large_series_out = true;
  const auto change = [&](Scene& scene) {
    apply(options, scene, request);
    if (scene.error && chooses_method(scene)) request.where_possible = {"jacobian"};
  };
  const EndsAtOnce while_it_derives(options.messages);
  return prepare(request, change, code);
}

}  // namespace gausssim
