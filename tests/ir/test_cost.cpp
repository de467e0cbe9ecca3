#include "catch_shim.hpp"
#include "ir/cost.hpp"
#include "ir/expr.hpp"

namespace {

using namespace gaussgen::ir;

struct Fixture {
  Graph graph;
  Expr m{graph, graph.use(graph.declare(SymbolClass::parameter, "m"))};
  Expr x{graph, graph.use(graph.declare(SymbolClass::configuration, "x"))};
  Expr y{graph, graph.use(graph.declare(SymbolClass::configuration, "y"))};
  Expr z{graph, graph.use(graph.declare(SymbolClass::configuration, "z"))};
  Expr one{graph, graph.constant(1)};

  OperationCount count(Expr a) const { return count_operations(graph, {a.id()}); }
};

const Rational k_half = Rational(1) / 2;

TEST_CASE_METHOD(Fixture, "sums and products count one operation less than operands", "[ir]") {
  CHECK(count(x + y + z).additions == 2);
  CHECK(count(x + y + one).additions == 2);
  CHECK(count(x * y * z).multiplications == 2);
  CHECK(count(x * y + z).total() == 2);
}

TEST_CASE_METHOD(Fixture, "signs are free and other coefficients cost a multiplication", "[ir]") {
  CHECK(count(x - y).total() == 1);
  CHECK(count(-x).total() == 0);
  CHECK(count(2 * x - 3 * y).multiplications == 2);
}

TEST_CASE_METHOD(Fixture, "powers count by repeated squaring", "[ir]") {
  CHECK(count(pow(x, 2)).total() == 1);
  CHECK(count(pow(x, 3)).total() == 2);
  CHECK(count(pow(x, 4)).total() == 2);
  CHECK(count(pow(x, 5)).total() == 3);
}

TEST_CASE_METHOD(Fixture, "a fraction is one division, however many factors it has", "[ir]") {
  CHECK(count(one / x).divisions == 1);
  CHECK(count(one / x).total() == 1);
  CHECK(count(y / x).total() == 1);
  CHECK(count(2 * (one / x)).total() == 1);
  CHECK(count(2 * (y / x)).total() == 2);
  CHECK(count((x * y) / (z * (x + y))).divisions == 1);
  CHECK(count((x * y) / (z * (x + y))).multiplications == 2);
  CHECK(count(one / (x * y)).total() == 2);
  CHECK(count(y + one / x).total() == 2);
  CHECK(count(call(Function::sin, one / x)).total() == 2);
}

TEST_CASE_METHOD(Fixture, "roots are counted apart from other functions", "[ir]") {
  CHECK(count(pow(x, k_half)).square_roots == 1);
  CHECK(count(pow(x, -k_half)).square_roots == 1);
  CHECK(count(pow(x, -k_half)).divisions == 1);
  CHECK(count(pow(x, Rational(1) / 3)).by_function.at("pow") == 1);
  CHECK(count(pow(x, Rational(-1) / 3)).divisions == 0);
}

TEST_CASE_METHOD(Fixture, "a shared node counts once", "[ir]") {
  const Expr s = call(Function::sin, x + y);
  CHECK(count_operations(graph, {(s * x).id(), (s * y).id()}).functions == 1);
  CHECK(count_operations(graph, {(s * x).id(), (s * y).id()}).total() == 4);
  CHECK(operations(graph, {s.id(), s.id()}) == 2);
}

TEST_CASE_METHOD(Fixture, "what depends on parameters alone is free unless preparation is asked for", "[ir]") {
  const Expr root = pow(m + one, k_half);
  CHECK(count(root).total() == 0);
  CHECK(count_operations(graph, {root.id()}, true).total() == 2);
  CHECK(count(root * x).total() == 1);
  // Division by a parameter is multiplication by a prepared reciprocal.
  CHECK(count(x / m).divisions == 0);
  CHECK(count(x / m).multiplications == 1);
}

TEST_CASE_METHOD(Fixture, "comparisons and choices are free", "[ir]") {
  const NodeId less = graph.call(Function::less, {x.id(), y.id()});
  CHECK(operations(graph, {graph.call(Function::select, {less, x.id(), z.id()})}) == 0);
}

TEST_CASE_METHOD(Fixture, "two ways to write a value compare as the counts of all that they stand on", "[ir]") {
  const Expr s = (x + y).named("s");
  const Expr r = pow(s, -1);
  // Below g lie x/s, z^2 and a reciprocal in a product, all of which are free for those who use them again.
  const Expr g = (x * r + pow(z, 2) + y).named("g");
  const std::vector<Expr> values{g + s,
                                 g + x * r,
                                 g + r,
                                 x * r * g,
                                 (g + s) * r,
                                 g * r + 1 * one,
                                 g * s + x * y,
                                 g * z * s + x * r,
                                 g * s + z * z * m,
                                 m * g * s,
                                 g * m + s * m,
                                 (g + s) * m,
                                 g,
                                 s + z,
                                 x + y};
  for (const Expr a : values) {
    for (const Expr b : values) {
      const int of_a = operations(graph, {a.id()});
      const int of_b = operations(graph, {b.id()});
      INFO(of_a << " and " << of_b);
      CHECK(takes_fewer_operations(graph, a.id(), b.id()) == (of_a < of_b));
    }
  }
}

}  // namespace
