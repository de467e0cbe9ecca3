#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/decimal.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/expr.hpp"

namespace {

using namespace gaussgen::evaluate;
using namespace gaussgen::ir;
using cln::cl_F;

struct Fixture {
  Graph graph;
  SymbolId x_id = graph.declare(SymbolClass::configuration, "x");
  SymbolId y_id = graph.declare(SymbolClass::configuration, "y");
  Expr x{graph, graph.use(x_id)};
  Expr y{graph, graph.use(y_id)};
  Expr one{graph, graph.constant(1)};
  Evaluator<double> in_double{graph, Arithmetic<double>()};
  Evaluator<cl_F> in_cln{graph, Arithmetic<cl_F>(50)};

  void bind(SymbolId symbol, double value) {
    in_double.bind(symbol, value);
    in_cln.bind(symbol, in_cln.arithmetic().number(value));
  }
  Expr less(Expr a, Expr b) { return {graph, graph.call(Function::less, {a.id(), b.id()})}; }
  Expr select(Expr condition, Expr a, Expr b) {
    return {graph, graph.call(Function::select, {condition.id(), a.id(), b.id()})};
  }
  std::string reason(Expr a) {
    const auto slow = in_cln.trouble(a.id());
    const auto fast = in_double.trouble(a.id());
    REQUIRE(slow.has_value());
    REQUIRE(fast.has_value());
    CHECK(slow->name == fast->name);
    CHECK(slow->reason == fast->reason);
    CHECK_FALSE(in_cln(a.id()).has_value());
    return slow->name + ": " + slow->reason;
  }
  double value(Expr a) {
    REQUIRE(in_double(a.id()).has_value());
    REQUIRE(in_cln(a.id()).has_value());
    CHECK(to_double(*in_cln(a.id())) == Approx(*in_double(a.id())).epsilon(1e-14));
    return *in_double(a.id());
  }
};

TEST_CASE_METHOD(Fixture, "every kind of node has its value", "[evaluate]") {
  bind(x_id, 3);
  bind(y_id, -2);
  CHECK(value(2 * x - y + one) == 9);
  CHECK(value(x * y) == -6);
  CHECK(value(pow(y, 3)) == -8);
  CHECK(value(x / y) == -1.5);
  CHECK(value((x + y).named("h") * x) == 3);
  CHECK(value(select(less(x, y), x, y)) == -2);
  CHECK(value(select(less(y, x), x, y)) == 3);
}

TEST_CASE_METHOD(Fixture, "binding again gives the new value", "[evaluate]") {
  bind(x_id, 3);
  CHECK(value(x * x) == 9);
  bind(x_id, 4);
  CHECK(value(x * x) == 16);
}

TEST_CASE_METHOD(Fixture, "pi and epsilon have the values of the type unless bound", "[evaluate]") {
  const SymbolId pi = graph.declare(SymbolClass::pi, "pi");
  const SymbolId epsilon = graph.declare(SymbolClass::epsilon, "epsilon");
  CHECK(in_double(graph.use(pi)) == 3.14159265358979323846);
  CHECK(in_double(graph.use(epsilon)) == 0x1p-53);
  CHECK(to_decimal(*in_cln(graph.use(pi)), 30) == "3.14159265358979323846264338328");
  CHECK(to_double(*in_cln(graph.use(epsilon))) < 1e-59);
  in_cln.bind(epsilon, in_cln.arithmetic().number(0x1p-53));
  CHECK(to_double(*in_cln(graph.use(epsilon))) == 0x1p-53);
}

TEST_CASE_METHOD(Fixture, "an undefined value makes what uses it undefined, and the first failure is named",
                 "[evaluate]") {
  bind(x_id, 2);
  bind(y_id, 2);
  const Expr pole = one / (x - y).named("gap");
  CHECK(reason(pole) == "gap^(-1): division by zero");
  CHECK(reason(call(Function::sin, pole + x) * y) == "gap^(-1): division by zero");
  CHECK(reason(call(Function::log, x - y - one)) == "log(-1 + x - y): logarithm of a number that is not positive");
  CHECK(reason(pow(-x, Rational(1) / 2)) == "(-x)^(1/2): fractional power of a negative number");
  CHECK(reason(call(Function::acos, x)) == "acos(x): inverse sine or cosine of a number outside [-1, 1]");
  const Expr labelled = (x * pow(x - y, -1)).named("slip");
  CHECK(reason(labelled * y) == "(x - y)^(-1): division by zero");
}

TEST_CASE_METHOD(Fixture, "a symbol without a value is named", "[evaluate]") {
  bind(x_id, 1);
  CHECK(reason(x * y + one) == "y: the symbol has no value");
}

TEST_CASE_METHOD(Fixture, "overflow is undefined in every type", "[evaluate]") {
  bind(x_id, 1e300);
  CHECK_FALSE(in_double((x * x).id()).has_value());
  CHECK(in_cln((x * x).id()).has_value());
  CHECK(reason(call(Function::exp, x)) == "exp(x): the number is too large");
}

TEST_CASE_METHOD(Fixture, "a choice looks at the chosen branch only", "[evaluate]") {
  bind(x_id, 0);
  bind(y_id, 1);
  const Expr pole = one / x;
  CHECK(value(select(less(x, y), y, pole)) == 1);
  CHECK(reason(select(less(y, x), y, pole)) == "x^(-1): division by zero");
  CHECK(reason(select(less(pole, y), x, y)) == "x^(-1): division by zero");
}

TEST_CASE_METHOD(Fixture, "conditions absorb undefined values where the answer is known", "[evaluate]") {
  bind(x_id, 0);
  bind(y_id, 1);
  const Expr pole = one / x;
  const auto condition = [this](Function function, const std::vector<NodeId>& arguments) {
    return Expr(graph, graph.call(function, arguments));
  };
  CHECK(value(condition(Function::not_finite, {pole.id(), y.id()})) == 1);
  CHECK(value(condition(Function::not_finite, {x.id(), y.id()})) == 0);
  const Expr known = less(x, y);
  const Expr unknown = less(pole, y);
  CHECK(value(condition(Function::any, {unknown.id(), known.id()})) == 1);
  CHECK(reason(condition(Function::any, {unknown.id(), less(y, x).id()})) == "x^(-1): division by zero");
}

TEST_CASE_METHOD(Fixture, "several nodes are evaluated in one pass", "[evaluate]") {
  bind(x_id, 0);
  bind(y_id, 5);
  const auto values = in_double.evaluate({y.id(), (one / x).id(), (y * y).id()});
  REQUIRE(values.size() == 3);
  CHECK(values[0] == 5.0);
  CHECK_FALSE(values[1].has_value());
  CHECK(values[2] == 25.0);
}

TEST_CASE_METHOD(Fixture, "a deep graph is evaluated without recursion", "[evaluate]") {
  bind(x_id, 1);
  Expr a = x;
  for (int i = 0; i < 100000; ++i) a = call(Function::sin, a);
  CHECK(in_double(a.id()).has_value());
}

}  // namespace
