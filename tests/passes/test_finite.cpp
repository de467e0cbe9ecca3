// Which values tell of all that they are finite: claims by hand, then floating-point arithmetic itself as the judge.

#include "passes/finite.hpp"

#include <cmath>
#include <limits>
#include <unordered_map>

#include "catch_shim.hpp"
#include "fixture.hpp"
#include "ir/traverse.hpp"
#include "random_graph.hpp"

using namespace gausstest;
using gaussgen::ir::Kind;
using gaussgen::ir::Rational;
using gaussgen::passes::fewest_to_check;

namespace {

struct Symbols {
  Graph graph;
  Expr x = declare(graph, SymbolClass::configuration, "x"), y = declare(graph, SymbolClass::configuration, "y"),
       z = declare(graph, SymbolClass::configuration, "z");

  /// Whether a look at `result` is a look at x.
  bool tells_of_x(Expr result) {
    const std::vector<NodeId> needed = fewest_to_check(graph, {x.id(), result.id()});
    REQUIRE(contains(needed, result));
    return needed.size() == 1;
  }
};

/// IEEE arithmetic for what RandomGraph is made of.
double value_of(const Graph& graph, NodeId root, const std::vector<double>& symbols) {
  std::unordered_map<std::uint32_t, double> values;
  for (const NodeId id : gaussgen::ir::post_order(graph, {root})) {
    const gaussgen::ir::Node& node = graph[id];
    const auto child = [&](std::size_t i) { return values.at(node.children[i].index); };
    double value = cln::double_approx(node.value);
    switch (node.kind) {
      case Kind::symbol: value = symbols[node.symbol.index]; break;
      case Kind::sum:
        for (std::size_t i = 0; i < node.children.size(); ++i)
          value += cln::double_approx(node.coefficients[i]) * child(i);
        break;
      case Kind::product:
        value = 1;
        for (std::size_t i = 0; i < node.children.size(); ++i) value *= child(i);
        break;
      case Kind::power: value = std::pow(child(0), value); break;
      case Kind::function: value = node.function == Function::sin ? std::sin(child(0)) : std::cos(child(0)); break;
      case Kind::named: value = child(0); break;
      default: break;
    }
    values[id.index] = value;
  }
  return values.at(root.index);
}

}  // namespace

TEST_CASE("sums, products, whole powers, square roots, sines and names tell of what is in them") {
  Symbols s;
  for (const Expr result : {s.x + s.y, s.x - s.y * s.z, s.x * s.y, pow(s.x, 3), pow(s.x * s.y, Rational(1) / 2),
                            call(Function::cos, s.x * s.y), (s.x * s.y).named("n") + s.z, s.x / s.y}) {
    CHECK(s.tells_of_x(result));
  }
}

TEST_CASE("a divisor, a function that is bounded and a choice do not") {
  Symbols s;
  const NodeId condition = s.graph.call(Function::less, {s.y.id(), s.z.id()});
  const Expr choice(s.graph, s.graph.call(Function::select, {condition, s.x.id(), s.y.id()}));
  for (const Expr result :
       {s.y / s.x, s.y / (s.x * s.x + s.z), call(Function::tanh, s.x), call(Function::exp, s.x), choice, s.y * s.z}) {
    CHECK_FALSE(s.tells_of_x(result));
  }
}

TEST_CASE("a NaN outlives a division, and a sine makes one of an infinity") {
  Symbols s;
  CHECK(s.tells_of_x(s.y / (call(Function::sin, s.x) + s.z)));
}

TEST_CASE("a sign is not looked at, nor is a value twice") {
  Symbols s;
  const Expr product = s.x * s.y;
  CHECK(fewest_to_check(s.graph, {(-product).id(), (product + s.z).id()}) == std::vector<NodeId>{(product + s.z).id()});
  CHECK(fewest_to_check(s.graph, {(-product).id(), product.id()}) == std::vector<NodeId>{product.id()});
}

TEST_CASE("more values than one word has bits for: each chain of sums is looked at once, at its end") {
  Graph graph;
  std::vector<NodeId> values, ends;
  for (int chain = 0; chain < 3; ++chain) {
    Expr sum = declare(graph, SymbolClass::configuration, "s" + std::to_string(chain));
    for (int i = 0; i < 50; ++i) {
      values.push_back(sum.id());
      sum = (sum + declare(graph, SymbolClass::configuration, "x" + std::to_string(50 * chain + i))).named("n");
    }
    ends.push_back(gaussgen::passes::unwrapped(graph, values.back()));
  }
  CHECK(fewest_to_check(graph, values) == ends);
}

TEST_CASE("what is left out of a check is not finite only where something in it is not, on 200 random graphs") {
  const double bad[] = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  std::size_t left_out = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomGraph random(seed, 14);
    std::vector<NodeId> values = random.outputs;
    for (std::uint32_t i = 0; i < 5; ++i) values.push_back(random.graph.use({i}));
    const std::vector<NodeId> needed = fewest_to_check(random.graph, values);
    left_out += values.size() - needed.size();
    for (std::size_t which = 0; which < 5; ++which) {
      for (const double number : bad) {
        std::vector<double> symbols{0.3, -0.7, 1.1, 0.9, -1.3};
        symbols[which] = number;
        const auto all_finite = [&](const std::vector<NodeId>& of) {
          return std::all_of(of.begin(), of.end(),
                             [&](NodeId id) { return std::isfinite(value_of(random.graph, id, symbols)); });
        };
        INFO("seed " << seed << ", symbol " << which << " is " << number);
        REQUIRE(all_finite(needed) == all_finite(values));
      }
    }
  }
  CHECK(left_out > 400);
}
