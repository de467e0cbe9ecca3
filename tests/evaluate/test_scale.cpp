#include <cmath>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/expr.hpp"

namespace {

using namespace gaussgen::evaluate;
using namespace gaussgen::ir;

struct Fixture {
  Graph graph;
  SymbolId x_id = graph.declare(SymbolClass::configuration, "x");
  SymbolId y_id = graph.declare(SymbolClass::configuration, "y");
  Expr x{graph, graph.use(x_id)};
  Expr y{graph, graph.use(y_id)};
  Expr one{graph, graph.constant(1)};
  Evaluator<Scaled<double>> evaluator{graph, Arithmetic<Scaled<double>>(Arithmetic<double>())};

  Fixture() {
    evaluator.bind(x_id, evaluator.arithmetic().input(3));
    evaluator.bind(y_id, evaluator.arithmetic().input(-4));
  }
  double value(Expr a) { return evaluator(a.id())->value; }
  double scale(Expr a) { return evaluator(a.id())->scale; }
};

TEST_CASE_METHOD(Fixture, "sums and products are taken over absolute values", "[evaluate]") {
  CHECK(value(x + y) == -1);
  CHECK(scale(x + y) == 7);
  CHECK(scale(2 * x + 3 * y - one) == 19);
  CHECK(scale(x * y) == 12);
  CHECK(value((x + y) * y) == 4);
  CHECK(scale((x + y) * y) == 28);
  CHECK(scale(pow(x + y, 2)) == 14);
  CHECK(scale((x + y).named("h")) == 7);
}

TEST_CASE_METHOD(Fixture, "functions carry the first-order bound and never less than the value", "[evaluate]") {
  CHECK(scale(call(Function::sin, x + y)) == Approx(std::cos(1.0) * 7));
  CHECK(scale(call(Function::exp, x + y)) == Approx(std::exp(-1.0) * 7));
  CHECK(scale(one / (x + y)) == 7);
  CHECK(scale(pow(x, Rational(1) / 2)) == Approx(std::sqrt(3.0)));
  CHECK(scale(call(Function::cos, x - x)) == 1);
  const Expr angle(graph, graph.call(Function::atan2, {y.id(), x.id()}));
  CHECK(value(angle) == std::atan2(-4.0, 3.0));
  CHECK(scale(angle) == Approx(24.0 / 25.0));
}

TEST_CASE_METHOD(Fixture, "of what is lost in a factor, a product feels the first order", "[evaluate]") {
  const Expr large = Rational(10000000) * x;
  const Expr sine = call(Function::sin, large);
  const double lost = std::fabs(std::cos(3e7)) * 3e7;
  CHECK(scale(sine) == Approx(lost));
  CHECK(scale(pow(sine, 2)) == Approx(2 * std::fabs(std::sin(3e7)) * lost));
  CHECK(scale(sine * sine * y) ==
        Approx(3 * std::sin(3e7) * std::sin(3e7) * 4 + 8 * std::fabs(std::sin(3e7)) * lost).epsilon(1e-6));
  CHECK(scale((x + y) * (x - x)) == 0);
}

TEST_CASE_METHOD(Fixture, "a choice has the scale of the chosen branch", "[evaluate]") {
  const Expr less(graph, graph.call(Function::less, {y.id(), x.id()}));
  const Expr choice(graph, graph.call(Function::select, {less.id(), (x + y).id(), y.id()}));
  CHECK(scale(choice) == 7);
}

TEST_CASE_METHOD(Fixture, "undefined values are reported as such", "[evaluate]") {
  const Expr pole = one / (x + y + one);
  CHECK_FALSE(evaluator(pole.id()).has_value());
  CHECK(evaluator.trouble(pole.id())->reason == reason::k_division);
}

TEST_CASE_METHOD(Fixture, "CLN has the same scales", "[evaluate]") {
  Evaluator<Scaled<cln::cl_F>> fine(graph, Arithmetic<Scaled<cln::cl_F>>(Arithmetic<cln::cl_F>(30)));
  const Arithmetic<cln::cl_F> base(30);
  fine.bind(x_id, fine.arithmetic().input(base.number(3.0)));
  fine.bind(y_id, fine.arithmetic().input(base.number(-4.0)));
  for (int i = 0; i <= static_cast<int>(Function::tanh); ++i) {
    const auto function = static_cast<Function>(i);
    const Expr inner = (x + y) / (4 * x);
    std::vector<NodeId> arguments{inner.id()};
    if (function == Function::atan2) arguments.push_back(x.id());
    if (function == Function::log) arguments[0] = (-inner).id();
    const Expr f(graph, graph.call(function, arguments));
    REQUIRE(evaluator(f.id()).has_value());
    REQUIRE(fine(f.id()).has_value());
    CHECK(cln::double_approx(fine(f.id())->scale) == Approx(scale(f)));
    CHECK(scale(f) >= std::fabs(value(f)));
  }
}

}  // namespace
