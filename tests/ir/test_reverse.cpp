// Reverse accumulation against forward derivatives.

#include "ir/reverse.hpp"

#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/decimal.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/cost.hpp"
#include "ir/differentiate.hpp"
#include "ir/print.hpp"
#include "ir/recipe.hpp"
#include "ir/verify.hpp"

namespace {

using namespace gauss_test;
using namespace gaussgen::ir;
using cln::cl_F;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;

Expr number(Graph& graph, int value) { return {graph, graph.constant(value)}; }

bool agrees(const cl_F& a, const cl_F& b) {
  const cl_F size = cln::abs(a) + cln::abs(b) + cln::cl_float(1, a);
  return gaussgen::evaluate::to_double(cln::abs(a - b) / size) < 1e-30;
}

}  // namespace

TEST_CASE("backwards come the same derivatives as forwards, of sums of functions with weights", "[ir]") {
  int compared = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const RecipePtr first = random_analytic_recipe(random, 4), second = random_analytic_recipe(random, 3);
    const Expr f(graph, build(*first, graph, symbols, random)), g(graph, build(*second, graph, symbols, random));
    if (graph.is_undefined(f.id()) || graph.is_undefined(g.id())) continue;
    const auto gradient = Reverse(graph, symbols.variables)({{f, number(graph, 3)}, {g, number(graph, -2)}}, "bar");
    Evaluator<cl_F> evaluator(graph, Arithmetic<cl_F>(60));
    const Point point = random_point(random);
    for (std::size_t i = 0; i < k_variables; ++i)
      evaluator.bind(symbols.variables[i], evaluator.arithmetic().number(point.variables[i]));
    for (std::size_t i = 0; i < k_variables; ++i) {
      INFO("seed " << seed << ": " << print(graph, f.id()));
      REQUIRE(violations(graph, {gradient[i].id()}) == std::vector<std::string>{});
      const Expr forwards = 3 * partial(f, symbols.variables[i]) - 2 * partial(g, symbols.variables[i]);
      const auto value = evaluator(gradient[i].id()), expected = evaluator(forwards.id());
      if (!value || !expected) continue;
      CHECK(agrees(*value, *expected));
      ++compared;
    }
  }
  CHECK(compared > 500);
}

TEST_CASE("all derivatives of a chain are few times as many operations as the chain", "[ir]") {
  Graph graph;
  std::vector<SymbolId> symbols;
  Expr value = number(graph, 1);
  constexpr int k_links = 400;
  for (int i = 0; i < k_links; ++i) {
    symbols.push_back(graph.declare(SymbolClass::configuration, "x" + std::to_string(i)));
    const Expr x(graph, graph.use(symbols.back()));
    value = (x * call(Function::sin, value) + value).named("v" + std::to_string(i));
  }
  const int before = operations(graph, {value.id()});
  std::vector<NodeId> gradient;
  for (const Expr derivative : Reverse(graph, symbols)({{value, number(graph, 1)}}, "bar"))
    gradient.push_back(derivative.id());
  CHECK(operations(graph, gradient) < 4 * before);
}

TEST_CASE("an argument that stands twice counts twice, a condition not at all", "[ir]") {
  Graph graph;
  const SymbolId id = graph.declare(SymbolClass::configuration, "x");
  const Expr x(graph, graph.use(id));
  const auto derivative = [&](Expr f) { return Reverse(graph, {id})({{f, number(graph, 1)}}, "bar")[0]; };
  CHECK(derivative(x * x * x) == 3 * pow(x, 2));
  const Expr direction(graph, graph.call(Function::atan2, {x.id(), x.id()}));
  CHECK(derivative(direction).is_zero());
  CHECK(derivative(select(less(x, number(graph, 0)), x, -x)) ==
        select(less(x, number(graph, 0)), number(graph, 1), number(graph, -1)));
}

TEST_CASE("what is not chosen may have no derivative", "[ir]") {
  Graph graph;
  const SymbolId id = graph.declare(SymbolClass::configuration, "x");
  const Expr x(graph, graph.use(id));
  const Expr root = pow(x, gaussgen::support::Rational(1) / 2);
  const Expr chosen(graph, graph.call(Function::piecewise, {less(number(graph, 0), x).id(), root.id(), x.id()}));
  const Expr derivative = Reverse(graph, {id})({{chosen * x, number(graph, 1)}}, "bar")[0];
  Evaluator<double> evaluator(graph, Arithmetic<double>());
  evaluator.bind(id, -3.0);
  REQUIRE(evaluator(derivative.id()));
  CHECK(*evaluator(derivative.id()) == Approx(-6));
}
