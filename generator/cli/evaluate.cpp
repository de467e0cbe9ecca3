#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/overrides.hpp"
#include "evaluation.hpp"
#include "kinematics/expressions.hpp"
#include "model/build.hpp"

namespace gaussgen::cli {

namespace {

bool is_number(const model::Ast& ast) {
  if (ast.kind == model::AstKind::symbol || ast.kind == model::AstKind::call || ast.kind == model::AstKind::power) return false;
  return std::all_of(ast.children.begin(), ast.children.end(), is_number);
}

support::Rational time_of(const Options& options, const model::Model& model) {
  const model::Ast ast = parse_value("--time", options.time, model);
  if (!is_number(ast)) throw UsageError("--time: expected a number, not '" + options.time + "'");
  return kinematics::constant_value(ast);
}

std::string table(const Evaluation& evaluation) {
  std::size_t name_width = 0;
  std::size_t value_width = 0;
  for (const EvaluatedValue& value : evaluation.values) {
    name_width = std::max(name_width, value.name.size());
    if (value.is_defined) value_width = std::max(value_width, value.text.size());
  }
  std::string text;
  std::string group;
  for (const EvaluatedValue& value : evaluation.values) {
    if (value.group != group) {
      text += (text.empty() ? "" : "\n") + value.group + "\n";
      group = value.group;
    }
    text += fmt::format("  {:<{}}  {:>{}}{}\n", value.name, name_width, value.text, value_width,
                        value.unit.empty() ? "" : "  " + value.unit);
  }
  return text;
}

std::string json(const Evaluation& evaluation, const model::Model& model, const Options& options) {
  nlohmann::ordered_json document;
  document["model"] = model.name.text;
  document["digits"] = options.digits;
  document["time"] = options.time;
  for (const EvaluatedValue& value : evaluation.values) {
    nlohmann::ordered_json entry;
    // Text, since a JSON number would be cut to a double.
    if (value.is_defined) {
      entry["value"] = value.text;
    } else {
      entry["undefined"] = value.text;
    }
    if (!value.unit.empty()) entry["unit"] = value.unit;
    document[value.group][value.name] = entry;
  }
  document["warnings"] = evaluation.warnings;
  return document.dump(2) + "\n";
}

}  // namespace

int evaluate(const Options& options) {
  const support::Source source = read_source(options.model);
  support::Diagnostics diagnostics;
  std::optional<model::Model> model = model::build_model(source, diagnostics);
  const int code = report(diagnostics, source);
  if (!model || code != k_ok) return code;
  for (const std::string& assignment : options.overrides) apply_override(assignment, *model);
  const support::Rational time = time_of(options, *model);
  Mechanics mechanics(*model, {});
  const Evaluation evaluation = evaluate_model(mechanics, time, options.digits);
  write_standard_output(options.format == Format::json ? json(evaluation, *model, options) : table(evaluation));
  for (const std::string& warning : evaluation.warnings) std::cerr << "warning: " << warning << "\n";
  return k_ok;
}

}  // namespace gaussgen::cli
