#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/overrides.hpp"
#include "cli/start.hpp"
#include "early_check.hpp"
#include "equilibrium.hpp"
#include "evaluation.hpp"
#include "read_model.hpp"
#include "strategy/projection.hpp"
#include "structure_check.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

namespace {

/// Columns in front of the decimal point, so that the points of a table stand under each other.
std::size_t whole_part(const std::string& number) { return std::min(number.find('.'), number.size()); }

/// How wide the columns of the table are.
struct Widths {
  std::size_t name = 0;
  std::size_t whole = 0;
  std::size_t value = 0;
  std::size_t unit = 0;
};

Widths widths_of(const std::vector<EvaluatedValue>& values) {
  Widths widths;
  for (const EvaluatedValue& value : values) {
    widths.name = std::max(widths.name, value.name.size());
    widths.unit = std::max(widths.unit, value.unit.size());
    if (value.is_defined) widths.whole = std::max(widths.whole, whole_part(value.text));
  }
  for (const EvaluatedValue& value : values) {
    if (value.is_defined)
      widths.value = std::max(widths.value, widths.whole - whole_part(value.text) + value.text.size());
  }
  return widths;
}

std::string without_blanks_at_end(const std::string& line) { return line.substr(0, line.find_last_not_of(' ') + 1); }

std::string line_of(const EvaluatedValue& value, const Widths& widths, const std::string& about) {
  if (!value.is_defined) return fmt::format("  {:<{}}  undefined: {}\n", value.name, widths.name, value.text);
  const std::string number = std::string(widths.whole - whole_part(value.text), ' ') + value.text;
  return without_blanks_at_end(fmt::format("  {:<{}}  {:<{}}  {:<{}}  {}", value.name, widths.name, number,
                                           widths.value, value.unit, widths.unit, about)) +
         "\n";
}

std::string rows(const std::vector<EvaluatedValue>& values) {
  const Widths widths = widths_of(values);
  std::string text;
  std::string group;
  std::string about;
  for (const EvaluatedValue& value : values) {
    if (value.group != group) text += "\n" + value.group + "\n";
    // What holds for several rows, such as the components of a force, stands at the first of them.
    const bool is_said = value.about == about && value.group != "state";
    text += line_of(value, widths, is_said ? "" : value.about);
    group = value.group;
    about = value.about;
  }
  return text;
}

std::string status_of(const Evaluation& evaluation) {
  if (evaluation.doubts.empty()) return "  ok\n";
  if (is_motion_trusted(evaluation))
    return "  ok, but for " + support::joined(evaluation.not_unique) +
           ": dependent_constraints, they are not unique and the least are shown\n";
  std::string text = "  not to be trusted: " + support::joined(evaluation.doubts) + "\n";
  const std::vector<std::string> undefined = undefined_groups(evaluation);
  if (undefined.empty()) return text;
  text += "  not_finite in " + support::joined(undefined);
  if (are_others_trusted(evaluation)) text += " alone: the other groups are to be trusted";
  return text + "\n";
}

std::string table(const Evaluation& evaluation) {
  std::string text = "status\n" + status_of(evaluation);
  text += rows(evaluation.values);
  if (!evaluation.notes.empty()) text += "\nnotes\n";
  for (const std::string& note : evaluation.notes) text += "  " + note + "\n";
  return text;
}

std::string json(const Evaluation& evaluation, const model::Model& model, const Options& options) {
  nlohmann::ordered_json document;
  document["model"] = model.name.text;
  document["digits"] = options.digits;
  document["time"] = options.time;
  document["status"] = evaluation.doubts.empty() ? "ok" : support::joined(evaluation.doubts);
  document["not_finite"] = undefined_groups(evaluation);
  document["not_unique"] = evaluation.not_unique;
  for (const EvaluatedValue& value : evaluation.values) {
    nlohmann::ordered_json entry;
    // Text, since a JSON number would be cut to a double.
    if (value.is_defined) {
      entry["value"] = value.text;
    } else {
      entry["undefined"] = value.text;
    }
    if (!value.unit.empty()) entry["unit"] = value.unit;
    if (!value.about.empty()) entry["about"] = value.about;
    document[value.group][value.name] = entry;
  }
  document["warnings"] = evaluation.warnings;
  document["notes"] = evaluation.notes;
  return document.dump(2) + "\n";
}

const std::vector<std::string> k_stages{"derivation", "initial state", "equilibrium", "evaluation"};

}  // namespace

int evaluate(const Options& options) {
  // What is wrong on the command line is said first.
  const support::Rational time = parse_time(options.time);
  std::optional<ReadingGuard> guard(options.messages);
  support::Source source = read_source(options.model);
  support::Diagnostics diagnostics;
  std::optional<model::Model> model = read_model(source, diagnostics, options.pipeline.choices);
  guard.reset();
  std::optional<WantedAccelerations> wanted;
  if (model) apply_overrides(options.overrides, *model);
  if (model && !options.accelerations.empty()) wanted = parse_accelerations(options.accelerations, *model);
  if (wanted && model::has_reactions_in_forces(*model))
    throw UsageError(
        "--accelerate: forces of this model depend on reactions, which are others in the motion that is asked for; "
        "make these forces inputs");
  const int code = report(diagnostics, source, options.messages);
  if (!model || code != k_ok) return code;
  std::optional<DerivationGuard> derivation(std::in_place, k_stages, options.most_seconds, options.messages);
  support::Diagnostics structure;
  check_early(*model, {}, structure);
  if (structure.has_errors()) return report(structure, source, options.messages);
  Mechanics mechanics(*model, {});
  check_structure(mechanics, structure);
  derivation->finish_stage();
  if (!structure.has_errors()) set_start(mechanics, *model, time, options.digits, options, structure);
  if (const int found = report(structure, source, options.messages); found != k_ok) return found;
  std::vector<std::string> doubts;
  std::optional<RestingMultipliers> resting;
  // Only initial values change, which the equations do not hold.
  derivation->finish_stage();
  if (options.at_equilibrium) {
    const Equilibrium found = go_to_equilibrium(mechanics, *model, time, options.digits);
    if (!found.failure.empty()) return fail(found.failure, k_model_error, options.messages, found.remedy);
    resting = found.multipliers;
    doubts = found.doubts;
  }
  derivation->finish_stage();
  Evaluation evaluation = evaluate_model(mechanics, time, options.digits, wanted, resting);
  evaluation.warnings.insert(evaluation.warnings.begin(), doubts.begin(), doubts.end());
  derivation.reset();  // before anything is written
  write_standard_output(options.format == Format::json ? json(evaluation, *model, options) : table(evaluation));
  for (const std::string& warning : evaluation.warnings) {
    const auto is_same = [&](const support::Diagnostic& found) { return found.message == warning; };
    const bool is_reported = std::any_of(diagnostics.all().begin(), diagnostics.all().end(), is_same);
    if (!is_reported) warn(warning, options.messages);
  }
  return k_ok;
}

}  // namespace gaussgen::cli
