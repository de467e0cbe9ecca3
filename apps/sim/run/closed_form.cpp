#include "sim/run/closed_form.hpp"

#include <quadmath.h>

#include "model/functions.hpp"
#include "support/table.hpp"

namespace gausssim {

namespace {

namespace model = gaussgen::model;
using Values = std::map<std::string, Quad>;

Quad value_of(const gaussgen::support::Integer& number) {
  return ::strtoflt128(gaussgen::support::to_text(gaussgen::support::Rational(number)).c_str(), nullptr);
}

Quad value_of(const gaussgen::support::Rational& number) {
  return value_of(cln::numerator(number)) / value_of(cln::denominator(number));
}

using Unary = Quad (*)(Quad);

const std::map<std::string, Unary>& unary_functions() {
  static const std::map<std::string, Unary> k_functions{
      {"sin", ::sinq},   {"cos", ::cosq},   {"tan", ::tanq}, {"asin", ::asinq}, {"acos", ::acosq},
      {"atan", ::atanq}, {"exp", ::expq},   {"log", ::logq}, {"sqrt", ::sqrtq}, {"sinh", ::sinhq},
      {"cosh", ::coshq}, {"tanh", ::tanhq}, {"abs", ::fabsq}};
  return k_functions;
}

Quad nothing() { return ::nanq(""); }

Quad evaluate(const model::Ast& ast, const Values& values);

/// Conditions in their order.
Quad chosen_case(const model::Ast& ast, const Values& values) {
  const auto& parts = ast.children;
  for (std::size_t i = 0; i + 1 < parts.size(); i += 2) {
    const Quad condition = evaluate(parts[i], values);
    if (!(condition == 0)) return condition == condition ? evaluate(parts[i + 1], values) : condition;
  }
  return evaluate(parts.back(), values);
}

/// Of all arguments; not a number if one of them is none.
Quad extreme(const model::Ast& ast, const Values& values) {
  Quad result = evaluate(ast.children[0], values);
  for (std::size_t i = 1; i < ast.children.size(); ++i) {
    const Quad next = evaluate(ast.children[i], values);
    if (!(next == next) || (ast.name == "min" ? next < result : next > result)) result = next;
  }
  return result;
}

Quad sign(Quad x) { return x == 0 ? x : ::copysignq(x == x ? Quad(1) : x, x); }

Quad compared(const model::Ast& ast, const Values& values) {
  const Quad a = evaluate(ast.children[0], values), b = evaluate(ast.children[1], values);
  if (!(a == a) || !(b == b)) return nothing();
  const bool holds = ast.name == "<" ? a < b : ast.name == "<=" ? a <= b : ast.name == ">" ? a > b : a >= b;
  return holds ? 1 : 0;
}

Quad call(const model::Ast& ast, const Values& values) {
  if (ast.table != nullptr)
    return gaussgen::support::value_at(*ast.table, 0, static_cast<double>(evaluate(ast.children[0], values)));
  if (ast.name == model::k_piecewise) return chosen_case(ast, values);
  if (ast.name == "min" || ast.name == "max") return extreme(ast, values);
  if (ast.name == "sign") return sign(evaluate(ast.children[0], values));
  const Quad first = evaluate(ast.children[0], values);
  if (ast.name == "atan2") return ::atan2q(first, evaluate(ast.children[1], values));
  const auto function = unary_functions().find(ast.name);
  return function == unary_functions().end() ? nothing() : function->second(first);
}

Quad combined(const model::Ast& ast, const Values& values) {
  const bool is_sum = ast.kind == model::AstKind::sum;
  Quad result = is_sum ? 0 : 1;
  for (const model::Ast& child : ast.children) {
    const Quad value = evaluate(child, values);
    result = is_sum ? result + value : result * value;
  }
  return result;
}

Quad evaluate(const model::Ast& ast, const Values& values) {
  switch (ast.kind) {
    case model::AstKind::number: return value_of(ast.number);
    case model::AstKind::symbol: {
      const auto found = values.find(ast.name);
      return found == values.end() ? nothing() : found->second;
    }
    case model::AstKind::negate: return -evaluate(ast.children[0], values);
    case model::AstKind::reciprocal: return 1 / evaluate(ast.children[0], values);
    case model::AstKind::power: return ::powq(evaluate(ast.children[0], values), evaluate(ast.children[1], values));
    case model::AstKind::sum:
    case model::AstKind::product: return combined(ast, values);
    case model::AstKind::call: return call(ast, values);
    case model::AstKind::comparison: return compared(ast, values);
    default: return nothing();
  }
}

}  // namespace

ClosedForms::ClosedForms(const PreparedModel& model) {
  values_["pi"] = ::acosq(-1);
  for (const auto& [name, value] : model.parameters) values_[name] = evaluate(value, values_);
  for (const Given& form : model.scene.exact) forms_.emplace(form.name, form.value);
}

Quad ClosedForms::at(const std::string& column, Quad t) const {
  Values values = values_;
  values["t"] = t;
  return evaluate(forms_.at(column), values);
}

Rows ClosedForms::instead_of(const Rows& rows, const PreparedModel& model) const {
  const auto& columns = model.columns.columns;
  const auto grid = grid_of<Quad>(model.span);
  Rows known = rows;
  for (long k = 0; k < rows.samples(); ++k) {
    std::vector<long double> row;
    for (std::size_t i = 0; i < columns.size(); ++i)
      row.push_back(has(columns[i].name) ? static_cast<long double>(at(columns[i].name, grid.at(k))) : rows.at(k, i));
    known.set(k, row);
  }
  return known;
}

}  // namespace gausssim
