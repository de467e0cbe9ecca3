// What is nothing but rounding is zero, and what rounding has left no digit of has no value.
#include "catch_shim.hpp"
#include "evaluate/arithmetic_paired.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/expr.hpp"

namespace {

using namespace gaussgen::evaluate;
using namespace gaussgen::ir;

constexpr int k_digits = 40;
constexpr int k_more = 20;

struct Fixture {
  Graph graph;
  SymbolId x_id = graph.declare(SymbolClass::configuration, "x");
  Expr x{graph, graph.use(x_id)};
  Expr pi{graph, graph.use(graph.declare(SymbolClass::pi, "pi"))};
  Evaluator<Paired> evaluator{graph, Arithmetic<Paired>(k_digits, k_more)};

  Expr number(int value) { return {graph, graph.constant(value)}; }
  Expr call(Function function, Expr a) { return {graph, graph.call(function, {a.id()})}; }
  Expr call(Function function, Expr a, Expr b) { return {graph, graph.call(function, {a.id(), b.id()})}; }
  void bind(const Rational& value) { evaluator.bind(x_id, evaluator.arithmetic().number(value)); }

  double value(Expr a) {
    const auto found = evaluator(a.id());
    REQUIRE(found);
    return cln::double_approx(found->fine);
  }
  std::string trouble(Expr a) {
    const auto found = evaluator.trouble(a.id());
    return found ? found->reason : "";
  }
};

TEST_CASE_METHOD(Fixture, "trigonometric functions have their zeros and poles where pi is rounded", "[evaluate]") {
  const Expr quarter = gaussgen::support::Rational(1) / 2 * pi;
  for (const int turns : {0, 1, -3, 50}) {
    const Expr at = quarter + turns * pi;
    CHECK(value(call(Function::cos, at)) == 0);
    CHECK(trouble(pow(call(Function::cos, at), -1)) == reason::k_division);
    CHECK(trouble(call(Function::tan, at)) == reason::k_pole);
    CHECK(trouble(call(Function::log, pow(call(Function::cos, at), 2))) == reason::k_logarithm);
    CHECK(value(pow(call(Function::cos, at), Rational(1) / 2)) == 0);
    CHECK(value(call(Function::sign, call(Function::cos, at))) == 0);
    CHECK(value(call(Function::at_most, number(0), call(Function::cos, at))) == 1);
    CHECK(value(call(Function::less, number(0), call(Function::cos, at))) == 0);
    CHECK(value(call(Function::less, call(Function::cos, at), number(0))) == 0);
  }
  CHECK(value(call(Function::atan2, call(Function::sin, pi), call(Function::cos, pi))) > 3.14);
}

TEST_CASE_METHOD(Fixture, "an arc of what is 1 up to rounding is one of 1", "[evaluate]") {
  bind(Rational(1) / 3);
  const Expr root = pow(x, Rational(1) / 2);
  // Its square is 1/3 in both precisions, up to rounding on either side.
  const Expr one = 3 * pow(call(Function::exp, call(Function::log, root)), 2);
  CHECK(value(call(Function::acos, one)) == 0);
  CHECK(value(call(Function::asin, -1 * one)) == Approx(-1.5707963267948966));
  CHECK(value(call(Function::less, one, number(1))) == 0);
  CHECK(value(call(Function::less, number(1), one)) == 0);
  bind(Rational(10) / 9);
  CHECK(trouble(call(Function::asin, x)) == reason::k_arc);
}

TEST_CASE_METHOD(Fixture, "what is small but not rounding stays", "[evaluate]") {
  const Expr one = number(1);
  const Expr square = pow(x + one, 2) - one - 2 * x;
  bind(Rational(1) / cln::expt(Rational(10), 20));
  CHECK(value(square) == Approx(1e-40));
  CHECK(value(call(Function::sin, x)) == Approx(1e-20));
  CHECK(value(one - call(Function::cos, x)) == Approx(5e-41));
  bind(Rational(1) / cln::expt(Rational(10), 40));
  CHECK(value(square) == 0);
  bind(Rational(1) / cln::expt(Rational(10), 300));
  CHECK(value(pow(x, -1)) == Approx(1e300));
}

TEST_CASE_METHOD(Fixture, "an angle with more digits before the point than are carried has no sine", "[evaluate]") {
  bind(Rational(10) / 3);
  CHECK(value(call(Function::sin, cln::expt(Rational(10), 20) * x)) != 0);
  CHECK(trouble(call(Function::sin, cln::expt(Rational(10), 200) * x)) == reason::k_rounding);
  CHECK(trouble(call(Function::cos, call(Function::exp, 100 * x))) == reason::k_rounding);
}

}  // namespace
