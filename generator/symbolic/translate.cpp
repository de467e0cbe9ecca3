#include "symbolic/translate.hpp"

#include <algorithm>
#include <vector>

#include "model/functions.hpp"
#include "support/assert.hpp"
#include "symbolic/choices.hpp"
#include "symbolic/rational.hpp"

namespace gaussgen::symbolic {

using GiNaC::ex;
using model::Ast;
using model::AstKind;

namespace {

ex call(const std::string& name, const ex& x) {
  using Unary = ex (*)(const ex&);
  static const std::map<std::string, Unary> k_functions = {
      {"sin", [](const ex& a) -> ex { return GiNaC::sin(a); }},
      {"cos", [](const ex& a) -> ex { return GiNaC::cos(a); }},
      {"tan", [](const ex& a) -> ex { return GiNaC::tan(a); }},
      {"asin", [](const ex& a) -> ex { return GiNaC::asin(a); }},
      {"acos", [](const ex& a) -> ex { return GiNaC::acos(a); }},
      {"atan", [](const ex& a) -> ex { return GiNaC::atan(a); }},
      {"exp", [](const ex& a) -> ex { return GiNaC::exp(a); }},
      {"log", [](const ex& a) -> ex { return GiNaC::log(a); }},
      {"sqrt", [](const ex& a) -> ex { return GiNaC::pow(a, GiNaC::numeric(1, 2)); }},
      {"sinh", [](const ex& a) -> ex { return GiNaC::sinh(a); }},
      {"cosh", [](const ex& a) -> ex { return GiNaC::cosh(a); }},
      {"tanh", [](const ex& a) -> ex { return GiNaC::tanh(a); }},
      {"abs", [](const ex& a) -> ex { return abs_of(a); }},
      {"sign", [](const ex& a) -> ex { return sign_of(a); }},
  };
  const auto found = k_functions.find(name);
  GAUSS_ASSERT(found != k_functions.end(), "function {}", name);
  return found->second(x);
}

ex extreme(bool is_least, const GiNaC::exvector& of) {
  ex result = of.front();
  for (std::size_t i = 1; i < of.size(); ++i) result = is_least ? ex(min_of(result, of[i])) : ex(max_of(result, of[i]));
  return result;
}

/// From the last case to the first one; a > b is b < a.
ex cases(const Ast& ast, const Scope& scope) {
  ex result = translate(ast.children.back(), scope);
  for (std::size_t i = ast.children.size() - 1; i >= 2; i -= 2) {
    const Ast& condition = ast.children[i - 2];
    const bool is_mirrored = condition.name[0] == '>';
    const ex a = translate(condition.children[is_mirrored ? 1 : 0], scope);
    const ex b = translate(condition.children[is_mirrored ? 0 : 1], scope);
    const ex value = translate(ast.children[i - 1], scope);
    const bool is_strict = condition.name.size() == 1;
    result = is_strict ? ex(case_less(a, b, value, result)) : ex(case_at_most(a, b, value, result));
  }
  return result;
}

ex call(const Ast& ast, const GiNaC::exvector& arguments, const Scope& scope) {
  if (ast.table != nullptr) return table_at(scope.tables.at(ast.name), 0, arguments[0]);
  if (ast.name == "dot") return scope.dot(arguments[0]);
  if (ast.name == "atan2") return GiNaC::atan2(arguments[0], arguments[1]);
  if (ast.name == "min" || ast.name == "max") return extreme(ast.name == "min", arguments);
  return call(ast.name, arguments[0]);
}

}  // namespace

ex translate(const Ast& ast, const Scope& scope) {
  if (ast.kind == AstKind::call && ast.name == model::k_piecewise) return cases(ast, scope);
  GiNaC::exvector children;
  children.reserve(ast.children.size());
  for (const Ast& child : ast.children) children.push_back(translate(child, scope));
  switch (ast.kind) {
    case AstKind::number: return number(ast.number);
    case AstKind::symbol: {
      if (ast.name.find('.') != std::string::npos) return scope.place(ast.name);
      const auto found = scope.values.find(ast.name);
      GAUSS_ASSERT(found != scope.values.end(), "name {}", ast.name);
      return found->second;
    }
    case AstKind::negate: return -children[0];
    case AstKind::sum: return GiNaC::add(children);
    case AstKind::product: return GiNaC::mul(children);
    case AstKind::reciprocal: return GiNaC::pow(children[0], -1);
    // GiNaC refuses 0^0, which a parameter less itself can hide; the other route takes x^0 as 1 for every x.
    case AstKind::power: return children[1].is_zero() ? ex(1) : GiNaC::pow(children[0], children[1]);
    case AstKind::call: return call(ast, children, scope);
    case AstKind::comparison: break;
  }
  GAUSS_ASSERT(false, "a comparison {} outside of piecewise", ast.name);
  return 0;
}

}  // namespace gaussgen::symbolic
