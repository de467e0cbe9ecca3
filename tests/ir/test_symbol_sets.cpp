// Derivatives by one of many symbols, which skip what does not depend on it.

#include "catch_shim.hpp"
#include "ir/differentiate.hpp"
#include "ir/recipe.hpp"

namespace {

using namespace gauss_test;
using namespace gaussgen::ir;

constexpr std::size_t k_many = 70;  // more than a word of bits

struct Many {
  Graph graph;
  std::vector<SymbolId> ids;
  std::vector<Expr> x;
  Many() {
    for (std::size_t i = 0; i < k_many; ++i) {
      ids.push_back(graph.declare(SymbolClass::speed, "x" + std::to_string(i)));
      x.emplace_back(graph, graph.use(ids.back()));
    }
  }
  Expr number(int value) { return {graph, graph.constant(value)}; }
  Directional along(SymbolSets& sets, std::size_t i) {
    Directional direction(graph);
    direction.seed(ids[i], number(1));
    direction.skip_others(sets, i);
    return direction;
  }
};

TEST_CASE("A derivative that skips what does not depend on its symbol is the same node") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const Expr f(graph, build(*random_analytic_recipe(random, 4), graph, symbols, random));
    SymbolSets sets(graph, symbols.variables);
    for (std::size_t i = 0; i < symbols.variables.size(); ++i) {
      Directional skipping(graph);
      skipping.seed(symbols.variables[i], Expr(graph, graph.constant(1)));
      skipping.skip_others(sets, i);
      INFO("seed " << seed << ", symbol " << i);
      CHECK(skipping(f) == partial(f, symbols.variables[i]));
    }
  }
}

TEST_CASE("Each symbol has its place in the sets, beyond the first word of bits too") {
  Many many;
  SymbolSets sets(many.graph, many.ids);
  const Expr f = many.x[3] * call(Function::sin, many.x[69]);
  for (std::size_t i = 0; i < k_many; ++i) CHECK(sets.depends(f.id(), i) == (i == 3 || i == 69));
  CHECK(many.along(sets, 69)(f) == many.x[3] * call(Function::cos, many.x[69]));
}

TEST_CASE("What has no value has no derivative by anything: it is not skipped") {
  Many many;
  SymbolSets sets(many.graph, many.ids);
  const Expr pole = pow(many.number(0), -1) * many.x[1];
  CHECK(many.along(sets, 0)(pole) == pole);
  const Expr choice = {
      many.graph, many.graph.call(Function::piecewise, {less(many.x[1], many.x[2]).id(), many.x[3].id(), pole.id()})};
  CHECK(many.along(sets, 0)(choice) == partial(choice, many.ids[0]));
}

}  // namespace
