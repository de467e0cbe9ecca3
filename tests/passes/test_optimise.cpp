#include "passes/optimise.hpp"

#include "catch_shim.hpp"
#include "ir/cost.hpp"
#include "ir/verify.hpp"
#include "passes/angles.hpp"
#include "passes/factor.hpp"
#include "passes/pairs.hpp"
#include "passes/quotients.hpp"
#include "passes/scale.hpp"
#include "random_graph.hpp"
#include "values.hpp"

using namespace gausstest;
using gaussgen::ir::operations;
using gaussgen::passes::Request;

namespace {

using Pass = Request (*)(Graph&, const Request&);

Request optimised(Graph& graph, const Request& request) {
  const Request simple = gaussgen::passes::optimise(graph, request, gaussgen::passes::identities());
  return gaussgen::passes::optimise(graph, simple, gaussgen::passes::passes());
}

const std::vector<std::pair<std::string, Pass>> k_passes{{"angles", gaussgen::passes::join_angles},
                                                         {"turns", gaussgen::passes::turn_back},
                                                         {"quotients", gaussgen::passes::join_quotients},
                                                         {"units", gaussgen::passes::choose_units},
                                                         {"pairs", gaussgen::passes::share_factors},
                                                         {"factors", gaussgen::passes::factor_out},
                                                         {"all", optimised}};

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

TEST_CASE("inertia in series: x - x x/(x + c) becomes x c/(x + c), whose digits do not cancel") {
  Graph graph;
  const Expr x = declare(graph, SymbolClass::configuration, "x");
  const Expr c = declare(graph, SymbolClass::configuration, "c");
  const Expr D = (x + c).named("D");
  const Expr left = x - x * x / D;
  const Request after = gaussgen::passes::join_quotients(graph, {{left.id()}, {}, {}});
  CHECK(after.outputs[0] == (x * c / D).id());
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
