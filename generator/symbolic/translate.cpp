#include "symbolic/translate.hpp"

#include <algorithm>
#include <vector>

#include "support/assert.hpp"
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
  };
  const auto found = k_functions.find(name);
  GAUSS_ASSERT(found != k_functions.end(), "function {}", name);
  return found->second(x);
}

}  // namespace

ex translate(const Ast& ast, const Scope& scope) {
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
    case AstKind::call: break;
  }
  if (ast.name == "dot") return scope.dot(children[0]);
  if (ast.name == "atan2") return GiNaC::atan2(children[0], children[1]);
  return call(ast.name, children[0]);
}

}  // namespace gaussgen::symbolic
