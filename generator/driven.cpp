#include "driven.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "evaluate/arithmetic_double.hpp"
#include "evaluation.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

using ir::Expr;
using support::Rational;

namespace {

void add_parameters(const model::Model& model, const model::Ast& ast, std::vector<std::string>& names) {
  const bool is_new = std::find(names.begin(), names.end(), ast.name) == names.end();
  if (ast.kind == model::AstKind::symbol && is_new && model.resolve(ast.name).kind == model::SymbolKind::parameter)
    names.push_back(ast.name);
  for (const model::Ast& child : ast.children) add_parameters(model, child, names);
}

}  // namespace

std::string driven_coordinates(Mechanics& mechanics, const Rational& time) {
  struct Law {
    const model::Coordinate& coordinate;
    Expr rate, acceleration;
  };
  std::vector<Law> laws;
  for (const kinematics::HeldCoordinate& held : mechanics.symbols.held) {
    const model::Coordinate& coordinate = mechanics.model.coordinates[held.model_index];
    const Expr rate = mechanics.expressions.rate(mechanics.expressions(*coordinate.held_at));
    laws.push_back({coordinate, rate, mechanics.expressions.rate(rate)});
  }
  evaluate::Evaluator<double> values(mechanics.graph, evaluate::Arithmetic<double>());
  bind_parameters(mechanics, values);
  values.bind(mechanics.symbols.time, values.arithmetic().number(time));
  std::string text;
  for (const Law& law : laws) {
    const double rate = values(law.rate.id()).value_or(0), acceleration = values(law.acceleration.id()).value_or(0);
    if (rate == 0 && acceleration == 0) continue;
    std::vector<std::string> names;
    add_parameters(mechanics.model, *law.coordinate.held_at, names);
    const auto with_unit = [&](double value, const char* per) {
      const std::string& unit = law.coordinate.unit;
      return fmt::format("{:.3g}{}", value, unit.empty() ? "" : " " + unit + per);
    };
    text += fmt::format(
        "{}the held coordinate '{}' moves at this time, at {} and {}, and drives the model: choose another "
        "--time{}",
        text.empty() ? "" : "; ", law.coordinate.name.text, with_unit(rate, "/s"), with_unit(acceleration, "/s^2"),
        names.empty() ? "" : ", or --set " + support::joined(names) + " such that it stands still");
  }
  return text;
}

}  // namespace gaussgen
