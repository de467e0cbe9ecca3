// Turns of pairs of components.

#include "catch_shim.hpp"
#include "ir/rotation.hpp"

namespace {

using namespace gaussgen::ir;

struct Fixture {
  Graph graph;
  Expr a{graph, graph.use(graph.declare(SymbolClass::configuration, "a"))};
  Expr b{graph, graph.use(graph.declare(SymbolClass::configuration, "b"))};
  Expr r{graph, graph.use(graph.declare(SymbolClass::parameter, "r"))};

  static Expr sin(Expr x) { return call(Function::sin, x); }
  static Expr cos(Expr x) { return call(Function::cos, x); }
};

using Pair = std::pair<Expr, Expr>;

TEST_CASE_METHOD(Fixture, "what has a polar angle is turned by adding to it, whichever of sine and cosine comes first",
                 "[ir]") {
  CHECK(turned(r * cos(a), r * sin(a), b) == Pair(r * cos(a + b), r * sin(a + b)));
  CHECK(turned(r * cos(a), -(r * sin(a)), b) == Pair(r * cos(a - b), -(r * sin(a - b))));
  CHECK(turned(r * sin(a), r * cos(a), b) == Pair(r * sin(a - b), r * cos(a - b)));
  CHECK(turned(-(3 * r * sin(a)), 3 * r * cos(a), b) == Pair(-(3 * r * sin(a + b)), 3 * r * cos(a + b)));
}

TEST_CASE_METHOD(Fixture, "turned back to the start it is constant", "[ir]") {
  const Expr zero(graph, graph.constant(0));
  CHECK(turned(r * cos(a), r * sin(a), -a) == Pair(r, zero));
  CHECK(turned(-(r * sin(a)), r * cos(a), -a) == Pair(zero, r));
}

TEST_CASE_METHOD(Fixture, "what has none is turned by sines and cosines of the angle", "[ir]") {
  CHECK(turned(r, a, b) == Pair(cos(b) * r - sin(b) * a, sin(b) * r + cos(b) * a));
  CHECK(turned(r * cos(a), r * sin(b), b) ==
        Pair(cos(b) * (r * cos(a)) - sin(b) * (r * sin(b)), sin(b) * (r * cos(a)) + cos(b) * (r * sin(b))));
}

TEST_CASE_METHOD(Fixture, "in axes turned by the polar angle one component vanishes", "[ir]") {
  for (const auto& [x, y] : {Pair(r * cos(a), r * sin(a)), Pair(r * cos(a), -(r * sin(a))),
                             Pair(r * sin(a), r * cos(a)), Pair(-(r * sin(a)), r * cos(a))}) {
    const auto angle = polar_angle(x, y);
    REQUIRE(angle);
    const Pair there = turned(x, y, -*angle);
    CHECK((there.first.is_zero() || there.second.is_zero()));
  }
  CHECK_FALSE(polar_angle(r * cos(a), r * sin(b)));
  CHECK_FALSE(polar_angle(r, a));
}

}  // namespace
