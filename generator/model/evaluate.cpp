#include "model/evaluate.hpp"

#include <cmath>
#include <vector>

#include "model/functions.hpp"

namespace gaussgen::model {

namespace {

using UnaryFunction = double (*)(double);

const std::map<std::string, UnaryFunction>& unary_functions() {
  static const std::map<std::string, UnaryFunction> functions = {
      {"sin", std::sin},   {"cos", std::cos},   {"tan", std::tan},   {"asin", std::asin},
      {"acos", std::acos}, {"atan", std::atan}, {"exp", std::exp},   {"log", std::log},
      {"sqrt", std::sqrt}, {"sinh", std::sinh}, {"cosh", std::cosh}, {"tanh", std::tanh}};
  return functions;
}

std::optional<double> call(const std::string& name, const std::vector<double>& arguments) {
  if (name == "atan2") return std::atan2(arguments[0], arguments[1]);
  const auto function = unary_functions().find(name);
  if (function == unary_functions().end()) return std::nullopt;
  return function->second(arguments[0]);
}

double combined(AstKind kind, const std::vector<double>& parts) {
  double value = kind == AstKind::sum ? 0.0 : 1.0;
  for (const double part : parts) value = kind == AstKind::sum ? value + part : value * part;
  return value;
}

}  // namespace

std::optional<double> value_of(const Ast& ast, const Values& values) {
  if (ast.kind == AstKind::number) return support::to_double(ast.number);
  if (ast.kind == AstKind::symbol) {
    const auto found = values.find(ast.name);
    return found == values.end() ? std::nullopt : std::optional<double>(found->second);
  }
  std::vector<double> parts;
  for (const Ast& child : ast.children) {
    const auto part = value_of(child, values);
    if (!part) return std::nullopt;
    parts.push_back(*part);
  }
  switch (ast.kind) {
    case AstKind::negate: return -parts[0];
    case AstKind::reciprocal: return 1.0 / parts[0];
    case AstKind::power: return std::pow(parts[0], parts[1]);
    case AstKind::call: return call(ast.name, parts);
    default: return combined(ast.kind, parts);
  }
}

Values parameter_values(const Model& model) {
  Values values{{"pi", std::acos(-1.0)}};
  for (const Parameter& parameter : model.parameters) {
    if (const auto value = value_of(parameter.value, values)) values[parameter.name.text] = *value;
  }
  return values;
}

}  // namespace gaussgen::model
