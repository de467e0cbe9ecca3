#include "sim/ensemble/vary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/overrides.hpp"
#include "model/evaluate.hpp"
#include "sim/ensemble/plan.hpp"
#include "sim/run/scene_values.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
namespace model = gaussgen::model;
using model::SymbolKind;

model::Ast number_of(double value) { return cli::parse_value("ensemble", fmt::format("{}", value)); }

class Varying {
 public:
  Varying(model::Model& model, gaussgen::support::Diagnostics& diagnostics)
      : model_(model), values_(model, diagnostics) {}

  Placed apply(const Varied& one) {
    if (one.section == Section::initial) return initial(one, number_of(nominal(one.distribution)));
    const bool is_input = one.section == Section::inputs;
    const SymbolKind kind = is_input ? SymbolKind::input : SymbolKind::parameter;
    if (is_declared(one, kind)) values_.give({one.name, own_value(one), one.span});
    return {is_input, one.name};
  }

 private:
  bool is_declared(const Varied& one, SymbolKind kind) {
    const auto symbol = model_.symbols.find(one.name);
    if (symbol != model_.symbols.end() && symbol->second.kind == kind) return true;
    const char* const what = kind == SymbolKind::input ? "input" : "parameter";
    const std::string hint = symbol != model_.symbols.end() ? place_of(model_, one.name, symbol->second)
                                                            : near_or_all(one.name, names_of(model_, kind));
    values_.error(one.span, fmt::format("'{}' is no {} of the model", one.name, what), hint);
    return false;
  }

  /// That of the model's file: of mechanisms that cannot be assembled with each value, it can with this one.
  model::Ast own_value(const Varied& one) const {
    const model::Values values = model::parameter_values(model_);
    const std::size_t index = model_.symbols.at(one.name).index;
    const bool is_input = one.section == Section::inputs;
    const auto value = model::value_of(is_input ? model_.inputs[index].value : model_.parameters[index].value, values);
    return number_of(value && std::isfinite(*value) ? *value : nominal(one.distribution));
  }

  Placed initial(const Varied& one, const model::Ast& value) {
    if (!values_.may_have_initial(one.name, one.span)) return {};
    const std::string name = add_parameter(one.name, value);
    model::Ast ast;
    ast.kind = model::AstKind::symbol;
    ast.name = name;
    values_.give({one.name, ast, one.span});
    return {false, name};
  }

  /// Nobody can write it, so it is told from all that are declared.
  std::string add_parameter(const std::string& quantity, const model::Ast& value) {
    std::string name = "start_of_";
    for (const char c : quantity) name += c == '(' || c == ')' || c == ' ' ? '_' : c;
    while (model_.symbols.count(name) > 0) name += "_";
    model::Parameter parameter;
    parameter.name = {name, model_.name.span};
    parameter.value = value;
    model_.symbols[name] = {SymbolKind::parameter, model_.parameters.size()};
    model_.parameters.push_back(std::move(parameter));
    return name;
  }

  model::Model& model_;
  ModelValues values_;
};

}  // namespace

std::vector<Placed> vary(const Scene& scene, model::Model& to, gaussgen::support::Diagnostics& diagnostics) {
  std::vector<Placed> places;
  Varying varying(to, diagnostics);
  for (const Varied& one : scene.ensemble->varied) places.push_back(varying.apply(one));
  return places;
}

}  // namespace gausssim
