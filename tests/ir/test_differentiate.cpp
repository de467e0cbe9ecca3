// Derivatives: known forms, and central differences in 60 digits as an independent witness.

#include <cln/real.h>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/decimal.hpp"
#include "evaluate/evaluator.hpp"
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

struct Fixture {
  Graph graph;
  SymbolId x_id = graph.declare(SymbolClass::configuration, "x");
  SymbolId y_id = graph.declare(SymbolClass::configuration, "y");
  Expr x{graph, graph.use(x_id)};
  Expr y{graph, graph.use(y_id)};
  std::string text(Expr a) const { return print(graph, a.id()); }
};

/// (f(x + h) - f(x - h)) / 2h with h = 1e-20: the error is of the order 1e-40 f'''.
std::optional<cl_F> central_difference(Evaluator<cl_F>& evaluator, NodeId f, SymbolId symbol, const Rational& at) {
  const Rational step = Rational(1) / cln::expt_pos(cln::cl_I(10), 20);
  evaluator.bind(symbol, evaluator.arithmetic().number(at + step));
  const std::optional<cl_F> above = evaluator(f);
  evaluator.bind(symbol, evaluator.arithmetic().number(at - step));
  const std::optional<cl_F> below = evaluator(f);
  evaluator.bind(symbol, evaluator.arithmetic().number(at));
  if (!above || !below) return std::nullopt;
  return (*above - *below) / evaluator.arithmetic().number(Rational(2 * step));
}

bool agrees(const cl_F& a, const cl_F& b, double tolerance) {
  const cl_F size = cln::abs(a) + cln::abs(b) + cln::cl_float(1, a);
  return gaussgen::evaluate::to_double(cln::abs(a - b) / size) < tolerance;
}

TEST_CASE_METHOD(Fixture, "each function has its derivative", "[ir]") {
  for (int i = 0; i <= static_cast<int>(Function::tanh); ++i) {
    const auto function = static_cast<Function>(i);
    const Expr inner = x * x + x / Expr(graph, graph.constant(3));
    std::vector<NodeId> arguments{inner.id()};
    if (function == Function::atan2) arguments.push_back((x + y).id());
    const Expr f(graph, graph.call(function, arguments));
    Evaluator<cl_F> evaluator(graph, Arithmetic<cl_F>(60));
    evaluator.bind(y_id, evaluator.arithmetic().number(Rational(2) / 7));
    const Rational at = Rational(3) / 11;
    const std::optional<cl_F> expected = central_difference(evaluator, f.id(), x_id, at);
    INFO(text(f) << " has the derivative " << text(partial(f, x_id)));
    REQUIRE(expected.has_value());
    REQUIRE(evaluator(partial(f, x_id).id()).has_value());
    CHECK(agrees(*evaluator(partial(f, x_id).id()), *expected, 1e-35));
  }
}

TEST_CASE("derivatives agree with differences in 60 digits", "[ir]") {
  int compared = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const RecipePtr recipe = random_analytic_recipe(random, 4);
    const Expr f(graph, build(*recipe, graph, symbols, random));
    const SymbolId symbol = symbols.variables[2];
    const Expr derivative = partial(f, symbol);
    INFO("seed " << seed << ": " << print(graph, f.id()));
    REQUIRE(violations(graph, {derivative.id()}) == std::vector<std::string>{});
    Evaluator<cl_F> evaluator(graph, Arithmetic<cl_F>(60));
    const Point point = random_point(random);
    for (std::size_t i = 0; i < k_variables; ++i) {
      evaluator.bind(symbols.variables[i], evaluator.arithmetic().number(point.variables[i]));
    }
    const std::optional<cl_F> value = evaluator(derivative.id());
    const std::optional<cl_F> expected = central_difference(evaluator, f.id(), symbol, point.variables[2]);
    if (!value || !expected) continue;
    // Beside a huge term that does not depend on the symbol, the difference has no digits left.
    if (cln::abs(*evaluator(f.id())) > cln::cl_float(1'000'000'000, *value)) continue;
    // A steep function leaves less of 1e-40; the rule itself would be wrong by much more.
    CHECK(agrees(*value, *expected, 1e-18));
    ++compared;
  }
  CHECK(compared > 200);
}

TEST_CASE_METHOD(Fixture, "a derivative along a direction is the sum over its seeds", "[ir]") {
  const Expr u(graph, graph.use(graph.declare(SymbolClass::speed, "u")));
  const Expr v(graph, graph.use(graph.declare(SymbolClass::speed, "v")));
  Directional along(graph);
  along.seed(x_id, u);
  along.seed(y_id, v);
  CHECK(along(x * y) == y * u + x * v);
  CHECK(along(pow(x, 3)) == 3 * pow(x, 2) * u);
  along.seed(y_id, Expr(graph, graph.constant(0)));
  CHECK(along(x * y) == y * u);
}

TEST_CASE_METHOD(Fixture, "what has no value has no derivative either", "[ir]") {
  const Expr pole = pow(x - x, -1);
  CHECK(partial(pole, x_id) == pole);
  CHECK(graph.is_undefined(partial(x * pole, x_id).id()));
}

TEST_CASE_METHOD(Fixture, "a derivative looks through names", "[ir]") {
  const Expr h = (x + y).named("h");
  CHECK(text(partial(pow(h, 2), x_id)) == "2*h");
}

TEST_CASE_METHOD(Fixture, "a choice is differentiated branch by branch", "[ir]") {
  const NodeId condition = graph.call(Function::less, {x.id(), y.id()});
  const Expr f(graph, graph.call(Function::select, {condition, pow(x, 2).id(), (3 * x).id()}));
  CHECK(text(partial(f, x_id)) == "select(less(x, y), 2*x, 3)");
}

TEST_CASE_METHOD(Fixture, "a constant has no derivative, nor has what does not contain the symbol", "[ir]") {
  CHECK(partial(Expr(graph, graph.constant(5)), x_id).is_zero());
  CHECK(partial(call(Function::sin, y), x_id).is_zero());
}

}  // namespace
