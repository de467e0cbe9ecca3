#include "passes/optimise.hpp"

#include "catch_shim.hpp"
#include "ir/cost.hpp"
#include "ir/print.hpp"
#include "ir/verify.hpp"
#include "passes/angles.hpp"
#include "passes/cancellation.hpp"
#include "passes/factor.hpp"
#include "passes/pairs.hpp"
#include "passes/quotients.hpp"
#include "passes/rotations.hpp"
#include "passes/scale.hpp"
#include "passes/terms.hpp"
#include "random_graph.hpp"
#include "values.hpp"

using namespace gausstest;
using gaussgen::ir::operations;
using gaussgen::passes::Request;

namespace {

using Pass = Request (*)(Graph&, const Request&);

Request optimised(Graph& graph, const Request& request) {
  const Request simple = gaussgen::passes::apply(graph, request, gaussgen::passes::identities());
  return gaussgen::passes::apply_best_order(graph, simple);
}

const std::vector<std::pair<std::string, Pass>> k_passes{
    {"cancellation", gaussgen::passes::keep_digits}, {"angles", gaussgen::passes::join_angles},
    {"turns", gaussgen::passes::turn_back},          {"quotients", gaussgen::passes::join_quotients},
    {"units", gaussgen::passes::choose_units},       {"pairs", gaussgen::passes::share_factors},
    {"factors", gaussgen::passes::factor_out},       {"terms", gaussgen::passes::share_terms},
    {"rotations", gaussgen::passes::rotate_angles},  {"all", optimised}};

}  // namespace

TEST_CASE("every pass leaves the values of 200 random graphs as they are") {
  for (const auto& [name, pass] : k_passes) {
    INFO(name);
    for (unsigned seed = 0; seed < 200; ++seed) {
      RandomGraph random(seed);
      const Request after = pass(random.graph, random.request());
      INFO("seed " << seed);
      REQUIRE(difference(random.graph, random.outputs, after.outputs, seed) < 1e-35);
      REQUIRE(gaussgen::ir::violations(random.graph, after.outputs).empty());
    }
  }
}

TEST_CASE("all passes together never take more operations, and a second run finds little") {
  int before = 0, after = 0, again = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomGraph random(seed);
    const Request once = optimised(random.graph, random.request());
    const Request twice = optimised(random.graph, once);
    const int operations_before = operations(random.graph, random.outputs);
    REQUIRE(operations(random.graph, once.outputs) <= operations_before);
    before += operations_before;
    after += operations(random.graph, once.outputs);
    again += operations(random.graph, twice.outputs);
  }
  CHECK(after < before * 19 / 20);
  CHECK(again > after * 97 / 100);
}

TEST_CASE("the same graph gives the same code, whatever nodes were made before") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    RandomGraph plain(seed), littered(seed);
    Expr litter = declare(littered.graph, SymbolClass::input, "litter");
    for (int i = 0; i < 100; ++i) litter = call(Function::exp, litter) * litter;
    const Request one = optimised(plain.graph, plain.request());
    const Request two = optimised(littered.graph, littered.request());
    for (std::size_t i = 0; i < one.outputs.size(); ++i) {
      CHECK(gaussgen::ir::print(plain.graph, one.outputs[i]) == gaussgen::ir::print(littered.graph, two.outputs[i]));
    }
  }
}

TEST_CASE("a product that two values share is computed once") {
  Graph graph;
  const Expr a = declare(graph, SymbolClass::configuration, "a");
  const Expr b = declare(graph, SymbolClass::configuration, "b");
  const Expr c = declare(graph, SymbolClass::configuration, "c");
  const Expr d = declare(graph, SymbolClass::configuration, "d");
  const Request after = gaussgen::passes::share_factors(graph, {{(a * b * c).id(), (a * b * d).id()}, {}, {}});
  CHECK(operations(graph, {(a * b * c).id(), (a * b * d).id()}) == 4);
  CHECK(operations(graph, after.outputs) == 3);
}

TEST_CASE("squares and reciprocals are factors like others") {
  Graph graph;
  const Expr A = declare(graph, SymbolClass::configuration, "A");
  const Expr B = declare(graph, SymbolClass::configuration, "B");
  const Expr D = declare(graph, SymbolClass::configuration, "D");
  const std::vector<NodeId> outputs{(A * A / D).id(), (A * B / D).id(), (B * B / D).id()};
  const Request after = gaussgen::passes::share_factors(graph, {outputs, {}, {}});
  // 1/D, A/D, B/D and three products
  CHECK(operations(graph, after.outputs) <= 6);
}

TEST_CASE("a common factor of private products is taken out, of shared ones it is not") {
  Graph graph;
  const Expr a = declare(graph, SymbolClass::configuration, "a");
  const Expr b = declare(graph, SymbolClass::configuration, "b");
  const Expr c = declare(graph, SymbolClass::configuration, "c");
  const Expr d = declare(graph, SymbolClass::configuration, "d");
  const Expr sum = a * b + a * c + d;
  CHECK(operations(graph, gaussgen::passes::factor_out(graph, {{sum.id()}, {}, {}}).outputs) == 3);
  const std::vector<NodeId> outputs{sum.id(), (a * b).id(), (a * c).id()};
  CHECK(operations(graph, gaussgen::passes::factor_out(graph, {outputs, {}, {}}).outputs) == 4);
}

TEST_CASE("a sum may be a common factor, and a number may") {
  Graph graph;
  const Expr a = declare(graph, SymbolClass::configuration, "a");
  const Expr b = declare(graph, SymbolClass::configuration, "b");
  const Expr c = declare(graph, SymbolClass::configuration, "c");
  const Expr d = declare(graph, SymbolClass::configuration, "d");
  const Expr by_sum = (a + b) * c + (a + b) * d;
  CHECK(operations(graph, gaussgen::passes::factor_out(graph, {{by_sum.id()}, {}, {}}).outputs) == 3);
  const gaussgen::ir::Rational third = gaussgen::ir::Rational(1) / 3;
  const Expr by_number = third * a - third * b + third * c * c + d;
  CHECK(operations(graph, {by_number.id()}) == 7);
  CHECK(operations(graph, gaussgen::passes::factor_out(graph, {{by_number.id()}, {}, {}}).outputs) == 5);
}

TEST_CASE("a number that multiplies the same value here and there does so once") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const gaussgen::ir::Rational f = gaussgen::ir::Rational(2) / 3;
  const std::vector<NodeId> outputs{(f * x + y).id(), (y - f * x * y).id()};
  CHECK(operations(graph, outputs) == 5);
  CHECK(operations(graph, gaussgen::passes::share_factors(graph, {outputs, {}, {}}).outputs) == 4);
}

TEST_CASE("what sums have in common is added once, in any multiple and with either sign") {
  Graph graph;
  const Expr a = declare(graph, SymbolClass::configuration, "a");
  const Expr b = declare(graph, SymbolClass::configuration, "b");
  const Expr c = declare(graph, SymbolClass::configuration, "c");
  const Expr d = declare(graph, SymbolClass::configuration, "d");
  const auto count = [&](const std::vector<NodeId>& outputs) {
    return operations(graph, gaussgen::passes::share_terms(graph, {outputs, {}, {}}).outputs);
  };
  CHECK(count({(a + b + c).id(), (a + b + d).id()}) == 3);
  CHECK(count({(a - b).id(), (b - a + c).id()}) == 2);
  CHECK(count({(a + 3 * b + c).id(), (d - 2 * a - 6 * b).id()}) == 5);
  CHECK(count({(a + b).id(), (a - b).id()}) == 2);
  CHECK(count({(a * b + c).id(), (-(a * b) - c).id()}) == 2);
}

TEST_CASE("terms are not shared at the price of a number that is rounded") {
  Graph graph;
  const Expr a = declare(graph, SymbolClass::configuration, "a");
  const Expr b = declare(graph, SymbolClass::configuration, "b");
  const Expr c = declare(graph, SymbolClass::configuration, "c");
  const auto& share = gaussgen::passes::share_terms;
  // 3 a + 5 b = 3 (a + 5/3 b)
  const std::vector<NodeId> whole{(3 * a + 5 * b + c).id(), (6 * a + 10 * b).id()};
  CHECK(share(graph, {whole, {}, {}}).outputs == whole);
  // 3 a + b is b + 3 a, whose factor is exact.
  const std::vector<NodeId> led{(3 * a + b + c).id(), (6 * a + 2 * b).id()};
  CHECK(operations(graph, share(graph, {led, {}, {}}).outputs) == 4);
}

TEST_CASE("a sum of angles takes the place of products where its sine is there anyway") {
  Graph graph;
  const Expr a = declare(graph, SymbolClass::configuration, "a");
  const Expr b = declare(graph, SymbolClass::configuration, "b");
  const Expr m = declare(graph, SymbolClass::parameter, "m");
  const Expr sin_a = call(Function::sin, a), cos_a = call(Function::cos, a);
  const Expr sin_b = call(Function::sin, b), cos_b = call(Function::cos, b);
  const Expr sin_sum = call(Function::sin, a + b), cos_difference = call(Function::cos, a - b);
  const auto joined = [&](Expr e, const std::vector<Expr>& others) {
    std::vector<NodeId> outputs{e.id()};
    for (const Expr other : others) outputs.push_back(other.id());
    return gaussgen::passes::join_angles(graph, {outputs, {}, {}}).outputs[0];
  };
  CHECK(joined(m * sin_a * cos_b + m * cos_a * sin_b + b, {sin_sum}) == (m * sin_sum + b).id());
  CHECK(joined(sin_a * sin_b + cos_a * cos_b, {cos_difference}) == cos_difference.id());
  const Expr alone = sin_a * cos_b + cos_a * sin_b;
  CHECK(joined(alone, {cos_difference}) == alone.id());
  // sin(a + b) cos b - cos(a + b) sin b = sin a
  CHECK(joined(sin_sum * cos_b - call(Function::cos, a + b) * sin_b, {sin_a, cos_a}) == sin_a.id());
}

TEST_CASE("what is turned there and back is as it was") {
  Graph graph;
  const Expr theta = declare(graph, SymbolClass::configuration, "theta");
  const Expr x = declare(graph, SymbolClass::speed, "x");
  const Expr y = declare(graph, SymbolClass::speed, "y");
  const Expr z = declare(graph, SymbolClass::speed, "z");
  const Expr m = declare(graph, SymbolClass::parameter, "m");
  const Expr s = call(Function::sin, theta), c = call(Function::cos, theta);
  const Expr X = (c * x + s * y).named("X"), Y = (c * y - s * x).named("Y");
  const auto turned = [&](Expr e, const std::vector<Expr>& others) {
    std::vector<NodeId> outputs{e.id()};
    for (const Expr other : others) outputs.push_back(other.id());
    return gaussgen::passes::turn_back(graph, {outputs, {}, {}}).outputs[0];
  };
  CHECK(turned(s * X + c * Y, {}) == y.id());
  CHECK(turned(z * c * X - z * s * Y, {X, Y}) == (x * z).id());
  // Also of what is made of turned values.
  const Expr P = (m * X + z * Y).named("P"), Q = (m * Y - z * X).named("Q");
  CHECK(turned(s * P + c * Q, {X, Y}) == (m * y - z * x).id());
  // Multiplied out, this is longer.
  const Expr other = s * X + c * (Y + z).named("Z");
  CHECK(turned(c * X + s * Y, {X, Y}) == (c * X + s * Y).id());
  CHECK(operations(graph, {turned(other, {X, Y})}) <= operations(graph, {other.id()}));
}

TEST_CASE("inertia in series: x - x x/(x + c) becomes x c/(x + c), whose digits do not cancel") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr c = declare(graph, SymbolClass::configuration, "c");
  const Expr D = (x + c).named("D");
  const Expr left = x - x * x / D;
  const Request after = gaussgen::passes::join_quotients(graph, {{left.id()}, {}, {}});
  CHECK(after.outputs[0] == (x * c / D).id());
}

TEST_CASE("the same where the difference is from a number, and where parts of the divisor have names") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr G = (2 * y * y + x * x).named("G");
  const Expr D = (G + 3 * x * x).named("D");
  const Expr left = Expr(graph, graph.constant(1)) - 4 * x * x / D;
  const Request after = gaussgen::passes::join_quotients(graph, {{left.id()}, {}, {}});
  CHECK(after.outputs[0] == (2 * y * y / D).id());
}

TEST_CASE("units leave numbers exact that are, and results without a factor") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const gaussgen::ir::Rational half = gaussgen::ir::Rational(1) / 2;
  // 3/2 + 9/4 x in units of 9/4 is 2/3 + x.
  const Expr D = (Expr(graph, graph.constant(3 * half)) + 9 * half * half * x).named("D");
  const std::vector<NodeId> exact{(y * D + y * y).id()};
  CHECK(gaussgen::passes::choose_units(graph, {exact, {}, {}}).outputs == exact);
  const gaussgen::ir::Rational f = gaussgen::ir::Rational(49) / 100;
  const std::vector<NodeId> result{(y * (f * x + f * y).named("N")).id()};
  CHECK(gaussgen::passes::choose_units(graph, {result, {}, {}}).outputs == result);
}

TEST_CASE("a value that is used in products only is computed in its own unit") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const Expr z = declare(graph, SymbolClass::configuration, "z");
  const gaussgen::ir::Rational f = gaussgen::ir::Rational(49) / 100;
  const Expr D = (f * x + f * y).named("D");
  const std::vector<NodeId> outputs{(f * z * D + y).id()};
  const Request after = gaussgen::passes::choose_units(graph, {outputs, {}, {}});
  CHECK(operations(graph, outputs) == 6);
  CHECK(operations(graph, after.outputs) == 4);
}

TEST_CASE("whether a value is finite is asked in its own unit, but of results in theirs") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr y = declare(graph, SymbolClass::configuration, "y");
  const gaussgen::ir::Rational f = gaussgen::ir::Rational(49) / 100;
  const Expr inertia = (f * x + f * y).named("M");
  const Expr result = f * (x * y + pow(x, 2));
  const NodeId question = graph.call(Function::not_finite, {inertia.id(), result.id()});
  const std::vector<NodeId> values{(x / inertia + y).id(), result.id()};
  const Request after = gaussgen::passes::choose_units(graph, {{values[0], values[1], question}, {}, {}});
  const auto& asked = graph[after.outputs[2]].children;
  CHECK(std::count(asked.begin(), asked.end(), after.outputs[1]) == 1);
  CHECK(operations(graph, after.outputs) == operations(graph, {after.outputs[0], after.outputs[1]}));
}
