// Sines, cosines and tangents of c pi + x against the mathematical library, and what they are exactly.

#include <cmath>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/expr.hpp"
#include "ir/print.hpp"

namespace {

using namespace gaussgen::ir;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;

struct Fixture {
  Graph graph;
  SymbolId pi_id = graph.declare(SymbolClass::pi, "pi");
  SymbolId x_id = graph.declare(SymbolClass::configuration, "x");
  Expr pi{graph, graph.use(pi_id)};
  Expr x{graph, graph.use(x_id)};
  Expr of(Function function, Expr angle) { return {graph, graph.call(function, {angle.id()})}; }
  std::string text(Function function, Expr angle) { return print(graph, of(function, angle).id()); }
};

}  // namespace

TEST_CASE_METHOD(Fixture, "whole angles have their rational values exactly, and no others") {
  CHECK(text(Function::sin, 2 * pi) == "0");
  CHECK(text(Function::cos, 2 * pi) == "1");
  CHECK(text(Function::sin, Rational(-1) / 2 * pi) == "-1");
  CHECK(text(Function::cos, Rational(1) / 2 * pi) == "0");
  CHECK(text(Function::sin, Rational(13) / 6 * pi) == "1/2");
  CHECK(text(Function::cos, Rational(2) / 3 * pi) == "-1/2");
  CHECK(text(Function::tan, Rational(5) / 4 * pi) == "1");
  CHECK(text(Function::tan, Rational(-1) / 4 * pi) == "-1");
  CHECK(graph[of(Function::sin, Rational(1) / 5 * pi).id()].kind == Kind::function);
  CHECK(graph[of(Function::sin, Rational(1) / 4 * pi).id()].kind == Kind::function);
}

TEST_CASE_METHOD(Fixture, "quarters of a turn leave sines and cosines of what stands beside them") {
  CHECK(of(Function::sin, x + Rational(1) / 2 * pi) == of(Function::cos, x));
  CHECK(of(Function::cos, x - Rational(1) / 2 * pi) == of(Function::sin, x));
  CHECK(of(Function::sin, pi - x) == of(Function::sin, x));
  CHECK(of(Function::tan, x + pi) == of(Function::tan, x));
  CHECK(graph[of(Function::tan, x + Rational(1) / 2 * pi).id()].kind == Kind::function);
}

TEST_CASE_METHOD(Fixture, "values are those of the library, whatever multiple of pi/12 is beside x") {
  Evaluator<double> values(graph, Arithmetic<double>());
  const double at = 0.37;
  values.bind(x_id, at);
  for (int k = -30; k <= 30; ++k) {
    for (const bool has_x : {false, true}) {
      const Expr angle = Rational(k) / 12 * pi + (has_x ? x : 0 * x);
      const double number = k * std::acos(-1.0) / 12 + (has_x ? at : 0);
      CHECK(values(of(Function::sin, angle).id()).value_or(9) == Approx(std::sin(number)).margin(1e-13));
      CHECK(values(of(Function::cos, angle).id()).value_or(9) == Approx(std::cos(number)).margin(1e-13));
      if (std::abs(std::cos(number)) < 1e-9) continue;
      CHECK(values(of(Function::tan, angle).id()).value_or(99) == Approx(std::tan(number)).margin(1e-12));
    }
  }
}
