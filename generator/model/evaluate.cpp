#include "model/evaluate.hpp"

#include <algorithm>
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

bool is_nan(double value) { return std::isnan(value); }

/// Not a number if one of the arguments is none.
std::optional<double> chosen(const std::string& name, const std::vector<double>& arguments) {
  if (name != "abs" && name != "sign" && name != "min" && name != "max") return std::nullopt;
  if (std::any_of(arguments.begin(), arguments.end(), is_nan)) return std::nan("");
  if (name == "abs") return std::abs(arguments[0]);
  if (name == "sign") return arguments[0] < 0 ? -1.0 : arguments[0] > 0 ? 1.0 : 0.0;
  if (name == "min") return *std::min_element(arguments.begin(), arguments.end());
  return *std::max_element(arguments.begin(), arguments.end());
}

std::optional<double> call(const std::string& name, const std::vector<double>& arguments) {
  if (const auto choice = chosen(name, arguments)) return choice;
  if (name == "atan2") return std::atan2(arguments[0], arguments[1]);
  const auto function = unary_functions().find(name);
  if (function == unary_functions().end()) return std::nullopt;
  return function->second(arguments[0]);
}

/// Conditions in their order; what is not chosen does not count, unless a symbol in it has no value.
double chosen_case(const std::vector<double>& parts) {
  for (std::size_t i = 0; i + 1 < parts.size(); i += 2) {
    if (is_nan(parts[i])) return parts[i];
    if (parts[i] != 0) return parts[i + 1];
  }
  return parts.back();
}

double compared(const Ast& ast, double a, double b) {
  if (is_nan(a) || is_nan(b)) return std::nan("");
  return holds(ast.name, a, b) ? 1.0 : 0.0;
}

std::optional<double> call(const Ast& ast, const std::vector<double>& parts) {
  if (ast.table != nullptr) return support::value_at(*ast.table, 0, parts[0]);
  if (ast.name == k_piecewise) return chosen_case(parts);
  return call(ast.name, parts);
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
    case AstKind::call: return call(ast, parts);
    case AstKind::comparison: return compared(ast, parts[0], parts[1]);
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
