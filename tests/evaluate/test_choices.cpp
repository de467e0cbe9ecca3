// abs, sign, min, max, piecewise and tables, in every number type.

#include "catch_shim.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/decimal.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/expr.hpp"

namespace {

using namespace gaussgen::evaluate;
using namespace gaussgen::ir;
using cln::cl_F;
using gaussgen::support::Table;

struct Fixture {
  Graph graph;
  SymbolId x_id = graph.declare(SymbolClass::configuration, "x");
  Expr x{graph, graph.use(x_id)};
  Expr one{graph, graph.constant(1)};
  Evaluator<double> in_double{graph, Arithmetic<double>()};
  Evaluator<cl_F> in_cln{graph, Arithmetic<cl_F>(50)};
  Evaluator<Scaled<double>> in_scales{graph, Arithmetic<Scaled<double>>(Arithmetic<double>())};

  Expr two(Function function, Expr a, Expr b) { return {graph, graph.call(function, {a.id(), b.id()})}; }
  Expr cases(Expr condition, Expr a, Expr b) {
    return {graph, graph.call(Function::piecewise, {condition.id(), a.id(), b.id()})};
  }
  void bind(double at) {
    in_double.bind(x_id, at);
    in_cln.bind(x_id, in_cln.arithmetic().number(at));
    in_scales.bind(x_id, in_scales.arithmetic().input(at));
  }
  double value(Expr a, double at) {
    bind(at);
    REQUIRE(in_double(a.id()).has_value());
    CHECK(to_double(*in_cln(a.id())) == Approx(*in_double(a.id())).epsilon(1e-14).margin(1e-14));
    CHECK(in_scales(a.id())->value == *in_double(a.id()));
    CHECK(in_scales(a.id())->scale >= std::abs(*in_double(a.id())));
    return *in_double(a.id());
  }
  bool has_value(Expr a, double at) {
    bind(at);
    const bool found = in_double(a.id()).has_value();
    CHECK(in_cln(a.id()).has_value() == found);
    CHECK(in_scales(a.id()).has_value() == found);
    return found;
  }
};

TEST_CASE_METHOD(Fixture, "each choice has its value on both sides and between", "[evaluate]") {
  const Expr size = call(Function::abs, x), sign = call(Function::sign, x);
  CHECK(value(size, -2.5) == 2.5);
  CHECK(value(size, 0) == 0);
  CHECK(value(size, 2.5) == 2.5);
  CHECK(value(sign, -1e-300) == -1);
  CHECK(value(sign, 0) == 0);
  CHECK(value(sign, 1e-300) == 1);
  CHECK(value(two(Function::min, x, one), 3) == 1);
  CHECK(value(two(Function::min, x, one), -3) == -3);
  CHECK(value(two(Function::max, one, x), 3) == 3);
  CHECK(value(cases(less(x, one), -x, 2 * x), 1) == 2);
  CHECK(value(cases(at_most(x, one), -x, 2 * x), 1) == -1);
}

TEST_CASE_METHOD(Fixture, "only what is chosen needs a value, and the condition", "[evaluate]") {
  const Expr logarithm = call(Function::log, x);
  CHECK(value(cases(less(one - one, x), logarithm, x), -2) == -2);
  CHECK_FALSE(has_value(cases(less(x, one), logarithm, x), -2));
  CHECK_FALSE(has_value(cases(less(logarithm, one), x, x + one), -2));
  CHECK_FALSE(has_value(two(Function::min, one, logarithm), -2));
  CHECK_FALSE(has_value(two(Function::max, logarithm, one), -2));
  CHECK_FALSE(has_value(call(Function::sign, logarithm), -2));
}

TEST_CASE_METHOD(Fixture, "a table is looked up at, between and beyond its points", "[evaluate]") {
  auto points = std::make_shared<Table>();
  points->name = "k";
  points->pieces = {{0, {1, 2, 0}}, {3, {7, Rational(1) / 3, -1}}};
  const TableId table = graph.declare(points);
  const auto at = [&](int order) { return Expr(graph, graph.look_up(table, order, x.id())); };
  CHECK(value(at(0), -2) == -3);
  CHECK(value(at(0), 1.5) == 4);
  CHECK(value(at(0), 3) == 7);
  CHECK(value(at(0), 6) == -1);
  CHECK(value(at(1), 2.999) == 2);
  CHECK(value(at(1), 3) == 1.0 / 3);
  CHECK(value(at(2), 0) == 0);
  CHECK(value(at(2), 3) == -2);
  CHECK_FALSE(has_value(Expr(graph, graph.look_up(table, 2, call(Function::log, x).id())), -1));
}

}  // namespace
