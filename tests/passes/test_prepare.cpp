#include "catch_shim.hpp"
#include "fixture.hpp"
#include "ir/print.hpp"
#include "passes/prepare.hpp"

using namespace gausstest;
using gaussgen::ir::print;
using gaussgen::ir::Rational;
using gaussgen::passes::PreparationSplit;

namespace {

struct Symbols {
  Graph graph;
  Expr m = declare(graph, SymbolClass::parameter, "m");
  Expr r = declare(graph, SymbolClass::parameter, "r");
  Expr epsilon = declare(graph, SymbolClass::epsilon, "eps");
  Expr x = declare(graph, SymbolClass::configuration, "x");
  Expr y = declare(graph, SymbolClass::configuration, "y");
  PreparationSplit split{graph, {}};

  std::vector<NodeId> roots;

  NodeId apply(Expr root) {
    roots.push_back(split(root.id()));
    return roots.back();
  }

  std::string prepared() const {
    std::string text;
    for (const auto& value : split.values_in(roots)) text += (text.empty() ? "" : "; ") + print(graph, value.value);
    return text;
  }
};

}  // namespace

TEST_CASE("maximal parts over parameters are prepared, once") {
  Symbols s;
  const NodeId first = s.apply((call(Function::sin, s.m + s.r) * s.x));
  const NodeId second = s.apply((call(Function::sin, s.m + s.r) * s.y));
  CHECK(s.prepared() == "sin(m + r)");
  CHECK(violations(s.graph, s.split, {first, second}).empty());
}

TEST_CASE("partial products and partial sums are prepared") {
  Symbols s;
  const NodeId product = s.apply((s.m * pow(s.r, 2) * s.x));
  CHECK(s.prepared() == "m*r^2");
  CHECK(s.graph[product].children.size() == 2);
  const NodeId sum = s.apply((s.m - s.r + s.x));
  CHECK(s.prepared() == "m*r^2; m - r");
  CHECK(violations(s.graph, s.split, {product, sum}).empty());
}

TEST_CASE("a rational factor goes into what is prepared, a whole one stays outside") {
  Symbols s;
  s.apply((Rational(2) / 5 * (s.m * s.x)));
  CHECK(s.prepared() == "2/5*m");
  s.apply((3 * (s.m * s.x) + s.y));
  CHECK(s.prepared() == "m; 2/5*m");
}

TEST_CASE("what differs in sign only is prepared once") {
  Symbols s;
  s.apply((Rational(1) / 2 * (s.m * s.x) + s.y));
  s.apply((s.x - Rational(1) / 2 * (s.m * s.y)));
  CHECK(s.prepared() == "1/2*m");
}

TEST_CASE("the rounding unit, numbers and conditions are not prepared") {
  Symbols s;
  const NodeId epsilon = s.apply((s.epsilon * s.x));
  CHECK(epsilon == (s.epsilon * s.x).id());
  const NodeId less = s.graph.call(Function::less, {s.m.id(), s.r.id()});
  const NodeId chosen = s.apply(Expr(s.graph, s.graph.call(Function::select, {less, s.x.id(), s.y.id()})));
  CHECK(s.prepared() == "m; r");
  CHECK(violations(s.graph, s.split, {epsilon, chosen}).empty());
}

TEST_CASE("an output over parameters alone is one prepared value") {
  Symbols s;
  const NodeId output = s.apply((s.m * s.r));
  CHECK(s.graph[output].kind == gaussgen::ir::Kind::symbol);
  CHECK(s.prepared() == "m*r");
}

TEST_CASE("names survive the split") {
  Graph graph;
  const Expr m = declare(graph, SymbolClass::parameter, "m");
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr inertia = (m + Expr(graph, graph.constant(2))).named("inertia");
  const Expr force = (m * m * x).named("force");
  PreparationSplit split(graph, {{(m * m).id().index, "wanted"}});
  const NodeId first = split((inertia * x).id());
  const NodeId second = split(call(Function::exp, force).id());
  const auto values = split.values_in({first, second});
  REQUIRE(values.size() == 2);
  CHECK(values[0].name == "inertia");
  CHECK(values[1].name == "wanted");
  CHECK(graph.label(graph[second].children[0]) == "force");
}

TEST_CASE("what was left unprepared is found out") {
  Symbols s;
  CHECK_FALSE(violations(s.graph, s.split, {((s.m + s.r) * s.x).id()}).empty());
}
