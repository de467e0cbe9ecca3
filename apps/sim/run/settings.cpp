#include "sim/run/settings.hpp"

#include <fmt/format.h>

#include "cli/overrides.hpp"
#include "cli/usage_error.hpp"
#include "sim/model/layout.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

constexpr double k_default_tolerance = 1e-9;
constexpr double k_default_steps = 10'000;  ///< of one length, in a run

/// Series where the model has them.
std::string default_method(const Described& model, const Engine& engine, const std::string& scalar) {
  const bool has_series = static_cast<bool>(engine.find("series_begin", scalar));
  return find_function(model.tree, "taylor") != nullptr && has_series ? "taylor" : "prince87";
}

}  // namespace

void apply(const RunOptions& options, Scene& scene) {
  const auto word = [](const std::string& text, std::optional<Word>& to) {
    if (!text.empty()) to = Word{text, {}};
  };
  word(options.method, scene.method);
  word(options.number, scene.number);
  word(options.projection, scene.projection);
  word(options.strategy, scene.strategy);
  word(options.engine, scene.engine);
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
  if (options.step) scene.step = options.step;
  if (!options.outputs.empty()) scene.outputs.clear();
  for (const std::string& name : options.outputs) scene.outputs.push_back({name, {}});
}

EngineChoice engine_choice(const Scene& scene) {
  if (!scene.engine || scene.engine->text == "auto") return EngineChoice::automatic;
  return scene.engine->text == "compiled" ? EngineChoice::compiled : EngineChoice::interpreted;
}

bool chooses_method(const Scene& scene) { return !scene.method || scene.method->text == "auto"; }

void check_method(const Scene& scene) {
  if (chooses_method(scene)) return;
  const MethodInfo& method = *find_method(scene.method->text);
  const auto refuse = [&](const std::string& why) {
    throw cli::UsageError(fmt::format("method '{}': {}", method.name, why));
  };
  if (!method.missing.empty()) refuse(method.missing);
  const std::string number = scene.number ? scene.number->text : "double";
  if (!method.has_long_double && number != "double") refuse("it computes in double, and no other number type");
  if (number == "float128" && method.name != "taylor") refuse("in float128 there is no method but taylor");
  if (!method.projects && scene.projection && scene.projection->text != "off")
    refuse("it does not project, so states drift off the constraints as its tolerance allows; take 'projection: off'");
}

Setting setting_of(const PreparedModel& prepared, const Engine& engine) {
  const Scene& scene = prepared.scene;
  Setting setting;
  if (scene.number) setting.number = scene.number->text;
  setting.method =
      chooses_method(scene) ? default_method(prepared.model, engine, scalar_of(setting.number)) : scene.method->text;
  const MethodInfo& method = *find_method(setting.method);
  setting.projection = scene.projection  ? projection_of(scene.projection->text)
                       : method.projects ? Projection::full
                                         : Projection::off;
  if (method.takes_step) {
    setting.step = scene.step.value_or(prepared.span.duration / k_default_steps);
  } else {
    setting.tolerance = scene.tolerance.value_or(k_default_tolerance);
  }
  return setting;
}

}  // namespace gausssim
