#include "sim/run/scene_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/usage_error.hpp"
#include "model/evaluate.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace cli = gaussgen::cli;
namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
using model::SymbolKind;

std::vector<std::string> names_of(const model::Model& in, SymbolKind kind) {
  std::vector<std::string> names;
  for (const auto& [name, symbol] : in.symbols) {
    if (symbol.kind == kind) names.push_back(name);
  }
  return names;
}

namespace {

const char* const k_hint_for_inputs =
    "an input has one value during a run; write what changes with t or the motion into the force of the model, in "
    "place of the input, as F*sin(w*t)";

/// Words for the command line, without their option.
std::string without_option(const std::string& text) {
  const std::size_t colon = text.rfind("--set", 0) == 0 ? text.find(": ") : std::string::npos;
  return colon == std::string::npos ? text : text.substr(colon + 2);
}

/// Whatever may begin somewhere.
std::vector<std::string> names_of_motion(const model::Model& in) {
  std::vector<std::string> names;
  for (const model::Coordinate& one : in.coordinates) {
    if (one.held_at) continue;
    names.push_back(one.name.text);
    if (!one.speed) names.push_back(one.name.text + "_dot");
  }
  for (const SymbolKind kind : {SymbolKind::quaternion_component, SymbolKind::speed, SymbolKind::angular_velocity}) {
    const auto more = names_of(in, kind);
    names.insert(names.end(), more.begin(), more.end());
  }
  return names;
}

/// What there is to choose from, where that is read at a glance.
std::string choice_of(const std::vector<std::string>& names) {
  constexpr std::size_t k_most = 12;
  return names.empty() || names.size() > k_most ? "" : "the model has " + gaussgen::support::joined(names);
}

}  // namespace

std::string place_of(const model::Model& in, const std::string& name, const model::SymbolRef& symbol) {
  switch (symbol.kind) {
    case SymbolKind::parameter: return "it belongs under 'parameters'";
    case SymbolKind::input: return "it belongs under 'inputs'";
    case SymbolKind::coordinate:
      if (in.coordinates[symbol.index].held_at)
        return fmt::format("its motion is the formula under 'held_at' of '{}': vary what that is made of", name);
      return "its start belongs under 'initial'";
    case SymbolKind::quaternion_component:
    case SymbolKind::angular_velocity:
    case SymbolKind::speed: return "its start belongs under 'initial'";
    default: return "";
  }
}

std::string near_or_all(const std::string& name, const std::vector<std::string>& names) {
  const std::string near = gaussgen::support::did_you_mean(name, names);
  return near.empty() ? choice_of(names) : near;
}

void ModelValues::error(gaussgen::support::Span span, const std::string& message, const std::string& hint) {
  diagnostics_.error(code::k_wrong_reference, span, message, hint);
}

void ModelValues::give(const Given& given, const std::string& hint) {
  // Why there is no value has been said; the name may be wrong, too.
  model::Ast value = given.value;
  if (model::is_broken(value)) value = cli::parse_value("", "1");
  try {
    overrides_.set("--set " + given.name, given.name, std::move(value));
    given_.push_back(given);
  } catch (const cli::UsageError& wrong) {
    error(given.span, without_option(wrong.what()), hint);
  }
}

bool ModelValues::may_have_initial(const std::string& name, gaussgen::support::Span span) {
  const auto symbol = model_.symbols.find(name);
  if (symbol == model_.symbols.end()) return true;
  const SymbolKind kind = symbol->second.kind;
  if (kind != SymbolKind::parameter && kind != SymbolKind::input) return true;
  error(span, fmt::format("'{}' has no initial value", name),
        fmt::format("it belongs under '{}'", kind == SymbolKind::input ? "inputs" : "parameters"));
  return false;
}

void ModelValues::check() {
  const model::Values values = model::parameter_values(model_);
  for (const Given& given : given_) {
    const auto value = model::is_broken(given.value) ? std::nullopt : model::value_of(given.value, values);
    if (value && !std::isfinite(*value))
      diagnostics_.error(code::k_undefined_value, given.value.span, cli::not_finite(*value));
  }
}

void give_values(const Scene& scene, model::Model& to, gaussgen::support::Diagnostics& diagnostics) {
  ModelValues values(to, diagnostics);
  // Scenes may keep values for effects that they do without.
  const auto is_absent = [&](const Given& given) {
    const std::string* const effect = cli::absent_effect_of(given.name, to);
    if (effect != nullptr)
      diagnostics.warning(code::k_unused, given.span,
                          fmt::format("'{}' is of the effect '{}', which does not act here", given.name, *effect));
    return effect != nullptr;
  };
  const auto give = [&](const Given& given, SymbolKind kind, const char* what, const char* hint) {
    if (is_absent(given)) return;
    const auto symbol = to.symbols.find(given.name);
    const bool is_known = symbol != to.symbols.end();
    if (is_known && symbol->second.kind != kind)
      return values.error(given.span, fmt::format("'{}' is no {} of the model", given.name, what),
                          place_of(to, given.name, symbol->second));
    values.give(given, is_known ? hint : choice_of(names_of(to, kind)));
  };
  for (const Given& given : scene.parameters) give(given, SymbolKind::parameter, "parameter", "");
  for (const Given& given : scene.inputs) give(given, SymbolKind::input, "input", k_hint_for_inputs);
  const std::string of_motion = choice_of(names_of_motion(to));
  for (const Given& given : scene.initial) {
    if (is_absent(given)) continue;
    const bool is_known = to.symbols.count(given.name) > 0;
    if (values.may_have_initial(given.name, given.span)) values.give(given, is_known ? "" : of_motion);
  }
  values.check();
}

}  // namespace gausssim
