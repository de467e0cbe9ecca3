#include "catch_shim.hpp"
#include "ir/expr.hpp"
#include "ir/latency.hpp"

namespace {

using namespace gaussgen::ir;

struct Fixture {
  Graph graph;
  Expr m{graph, graph.use(graph.declare(SymbolClass::parameter, "m"))};
  Expr x{graph, graph.use(graph.declare(SymbolClass::configuration, "x"))};
  Expr y{graph, graph.use(graph.declare(SymbolClass::configuration, "y"))};
  Expr z{graph, graph.use(graph.declare(SymbolClass::configuration, "z"))};

  int of(Expr e) const { return latency(graph, {e.id()}); }
};

TEST_CASE_METHOD(Fixture, "what needs the result of another waits for it", "[ir]") {
  CHECK(of(x) == 0);
  CHECK(of(x + y) == 4);
  CHECK(of((x + y) * z) == 8);
  CHECK(of(pow(x + y, -1)) == 18);
  CHECK(of(pow(x + y, Rational(1) / 2)) == 22);
  CHECK(of(call(Function::sin, x)) > of(pow(x, -1)));
}

TEST_CASE_METHOD(Fixture, "what does not, is done meanwhile", "[ir]") {
  CHECK(of((x + y) * (y + z)) == 8);
  CHECK(latency(graph, {(x + y).id(), (y * z).id()}) == 4);
}

TEST_CASE_METHOD(Fixture, "sums and products begin with what is ready first", "[ir]") {
  const Expr late = pow(x + y, -1);
  CHECK(of(late + x + y) == 18 + 4);
  CHECK(of(late * x * y) == 18 + 4);
  CHECK(of(x + y + z) == 8);
  CHECK(of(2 * x + y) == 8);
}

TEST_CASE_METHOD(Fixture, "what parameters alone make is there before", "[ir]") {
  CHECK(of(pow(m, -1) * call(Function::sin, m)) == 0);
  CHECK(of(pow(m, -1) * x) == 4);
}

TEST_CASE_METHOD(Fixture, "chains of any length are no recursion", "[ir]") {
  Expr chain = x;
  for (int i = 0; i < 100'000; ++i) chain = (chain + y).named("n" + std::to_string(i)) * z;
  CHECK(of(chain) >= 800'000);
}

}  // namespace
