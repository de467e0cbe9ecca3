#include "sim/advise/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "sim/advise/from_study.hpp"
#include "sim/advise/search.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/settings.hpp"
#include "sim/scene/choices.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using Json = nlohmann::ordered_json;

StudyPoint point_of(const Trial& trial) {
  const Setting& setting = trial.setting;
  return {"",
          "optimised",
          setting.method,
          setting.number,
          name_of(setting.projection),
          setting.tolerance,
          setting.step,
          trial.error.value,
          trial.seconds,
          setting.longest_step,
          trial.steps};
}

/// Most methods end a step at each sample. Where these are about as close as steps, if only for a part of the time, an error is delivered by samples as much as by the tolerance, and in a
/// scene with fewer of them it is not, unless its steps are as short.
void keep_steps(StudyPoint& point, const Span& span) {
  constexpr double k_few = 10;  ///< steps from a sample to the next
  const auto parts = static_cast<double>(span.samples - 1);
  if (!find_method(point.method)->ends_at_samples || point.step > 0 ||
      static_cast<double>(point.steps) >= k_few * parts)
    return;
  // Written out with three digits, it is no shorter than what it was, which would take another step.
  const double between = span.duration / parts;
  const double unit = std::pow(10.0, std::floor(std::log10(between)) - 2);
  constexpr double k_rounding = 1e-9;
  const double longest = std::stod(fmt::format("{:.6g}", std::ceil(between / unit * (1 - k_rounding)) * unit));
  if (point.longest_step == 0 || point.longest_step > longest) point.longest_step = longest;
}

std::string in_words(const StudyPoint& point) {
  return fmt::format(
      "{:<24}{:<12}{:<12}{:<14}{:>10.1e}{:>12.3f} ms", point.method, point.number, point.projection,
      point.step > 0 ? fmt::format("step {:.3g}", point.step) : fmt::format("tol. {:.1e}", point.tolerance),
      point.error, 1e3 * point.seconds);
}

/// Over the lines of in_words.
std::string head() {
  return fmt::format("{:<24}{:<12}{:<12}{:<14}{:>10}{:>15}", "method", "number", "projection", "accuracy", "error",
                     "time");
}

/// By which a study has formed the scene's own form. Empty: it is another one.
std::string strategy_of(const StudyPoint& point, const std::string& own_form) {
  for (const std::string& strategy : strategy_names()) {
    if (point.formulation == form_by_strategy(own_form, strategy)) return strategy;
  }
  return "";
}

/// Lines of a scene.
std::string as_scene(const StudyPoint& point, const std::string& own_form) {
  std::string text = fmt::format("method: {}\n", point.method);
  text += point.step > 0 ? fmt::format("step: {}\n", point.step) : fmt::format("tolerance: {}\n", point.tolerance);
  if (point.longest_step > 0) text += fmt::format("longest_step: {}\n", point.longest_step);
  text += fmt::format("number: {}\nprojection: {}\n", point.number, point.projection);
  if (const std::string strategy = strategy_of(point, own_form); !strategy.empty())
    text += fmt::format("strategy: {}\n", strategy);
  else if (!point.formulation.empty() && point.formulation != own_form)
    text += fmt::format("# formulation: {} (as under 'formulations' of the scene)\n", point.formulation);
  if (!point.code.empty() && point.code != code_names().front()) text += fmt::format("code: {}\n", point.code);
  return text;
}

Json as_json(const StudyPoint& point) {
  Json json{{"method", point.method}, {"number", point.number}, {"projection", point.projection}};
  json[point.step > 0 ? "step" : "tolerance"] = point.step > 0 ? point.step : point.tolerance;
  if (point.longest_step > 0) json["longest_step"] = point.longest_step;
  if (!point.formulation.empty()) json["formulation"] = point.formulation;
  json["error"] = point.error;
  json["time_s"] = point.seconds;
  return json;
}

void write(const AdviseOptions& options, const PreparedModel& prepared, StudyPoint best,
           const std::vector<StudyPoint>& others, const std::string& said) {
  keep_steps(best, prepared.span);
  if (options.format == "json") {
    Json json{{"asked", *options.error}, {"found", as_json(best)}, {"reference", said}, {"tried", Json::array()}};
    for (const StudyPoint& other : others) json["tried"].push_back(as_json(other));
    cli::write_standard_output(json.dump(2) + "\n");
    return;
  }
  std::string text = others.empty() ? "" : "#  " + head() + "\n";
  for (const StudyPoint& other : others) text += "#  " + in_words(other) + "\n";
  text += fmt::format("# delivers {:.1e} of {:.1e} in {:.3g} ms; reference: {}\n", best.error, *options.error,
                      1e3 * best.seconds, said);
  cli::write_standard_output(text + as_scene(best, prepared.scene.form));
}

}  // namespace

int advise(const AdviseOptions& options) {
  const Interruption interruption;
  int code = cli::k_ok;
  const auto prepared = prepare_run(options, code);
  if (!prepared) return code;
  const double error = *prepared->scene.error;
  std::string why;
  if (!options.study.empty()) {
    StudyPoint best = cheapest_in_study(
        options.study, *prepared, [&](const std::string& form) { return prepare_form(options, form); }, error, why);
    if (!why.empty()) return cli::fail(why, cli::k_not_delivered, options.messages);
    if (best.step == 0) best.longest_step = prepared->scene.longest_step.value_or(0);
    write(options, *prepared, best, {}, "that of " + std::filesystem::path(options.study).filename().string());
    return cli::k_ok;
  }
  const double budget = options.budget.value_or(Wanted().budget);
  const TimeLimit limit(budget, TimeLimit::Of::all);
  Engines engines(*prepared, engine_choice(prepared->scene));
  if (engines.of(number_name(prepared->scene)) == nullptr)
    return cli::fail(engines.why(), cli::k_file_error, options.messages);
  warn_of_interpreting(engines.times(), options.messages);
  const auto found = find_setting(*prepared, engines, {error, budget, !options.quiet}, why);
  if (!found) return cli::fail(why, cli::k_not_delivered, options.messages);
  std::vector<StudyPoint> tried;
  for (const Trial& trial : found->trials) tried.push_back(point_of(trial));
  write(options, *prepared, point_of(found->chosen), tried,
        fmt::format("{}, good to {:.1e}", found->reference_in_words, found->agreement));
  return cli::k_ok;
}

}  // namespace gausssim
