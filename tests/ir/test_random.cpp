// Properties that hold for every expression, on seeded random ones.

#include "catch_shim.hpp"
#include "ir/contract.hpp"
#include "ir/cost.hpp"
#include "ir/print.hpp"
#include "ir/recipe.hpp"
#include "ir/substitute.hpp"
#include "ir/verify.hpp"

namespace {

using namespace gauss_test;
using namespace gaussgen::ir;

constexpr unsigned k_expressions = 1500;

TEST_CASE("the printed form depends neither on the order of construction nor on when symbols are declared", "[ir]") {
  for (unsigned seed = 1; seed <= k_expressions; ++seed) {
    Random choice(seed);
    const RecipePtr recipe = random_recipe(choice, 5);
    std::string first;
    for (unsigned order = 0; order < 4; ++order) {
      Random random(1000 * seed + order);
      Graph graph;
      const Symbols symbols = declare_symbols(graph, random);
      // Other expressions that happen to be in the graph already must not matter.
      if (order > 1) build(*random_recipe(random, 4), graph, symbols, random);
      const std::string text = print(graph, build(*recipe, graph, symbols, random));
      if (order == 0) first = text;
      INFO("seed " << seed << ", order " << order);
      REQUIRE(text == first);
    }
  }
}

TEST_CASE("every invariant holds after any construction", "[ir]") {
  for (unsigned seed = 1; seed <= k_expressions; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const RecipePtr recipe = seed % 2 == 0 ? random_recipe(random, 6) : random_analytic_recipe(random, 5);
    const std::vector<std::string> found = violations(graph, {build(*recipe, graph, symbols, random)});
    INFO("seed " << seed);
    REQUIRE(found == std::vector<std::string>{});
  }
}

TEST_CASE("simplification keeps the exact value", "[ir]") {
  int compared = 0;
  for (unsigned seed = 1; seed <= k_expressions; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const RecipePtr recipe = random_recipe(random, 5);
    const NodeId node = build(*recipe, graph, symbols, random);
    for (int i = 0; i < 2; ++i) {
      const Point point = random_point(random);
      const std::optional<Rational> expected = exact_value(*recipe, point);
      if (!expected) continue;
      const std::optional<Rational> value = exact_value(graph, node, symbols, point);
      INFO("seed " << seed << ": " << print(graph, node));
      REQUIRE(value.has_value());
      REQUIRE(gaussgen::support::to_text(*value) == gaussgen::support::to_text(*expected));
      ++compared;
    }
  }
  REQUIRE(compared > static_cast<int>(k_expressions));
}

TEST_CASE("contract keeps the exact value and never costs more than the plain form", "[ir]") {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    std::vector<std::pair<Expr, Expr>> pairs;
    std::vector<RecipePtr> recipes;
    for (int i = 0; i < 6; ++i) recipes.push_back(random_recipe(random, 3));
    for (std::size_t i = 0; i < 6; i += 2) {
      const Expr left(graph, build(*recipes[i], graph, symbols, random));
      const Expr right(graph, build(*recipes[i + 1], graph, symbols, random));
      pairs.emplace_back(left, right);
    }
    const Expr plain =
        pairs[0].first * pairs[0].second + pairs[1].first * pairs[1].second + pairs[2].first * pairs[2].second;
    const Expr contracted = contract(graph, pairs);
    INFO("seed " << seed << ": " << print(graph, plain.id()));
    CHECK(operations(graph, {contracted.id()}) <= operations(graph, {plain.id()}));
    CHECK(violations(graph, {contracted.id()}) == std::vector<std::string>{});
    const Point point = random_point(random);
    const std::optional<Rational> expected = exact_value(graph, plain.id(), symbols, point);
    if (expected) REQUIRE(exact_value(graph, contracted.id(), symbols, point) == expected);
  }
}

TEST_CASE("substituting every symbol by itself changes nothing", "[ir]") {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const Expr node(graph, build(*random_recipe(random, 5), graph, symbols, random));
    Substitution identity(graph);
    for (const SymbolId symbol : symbols.variables) identity.replace(symbol, Expr(graph, graph.use(symbol)));
    REQUIRE(identity(node) == node);
  }
}

TEST_CASE("substitution of a number gives the value at that number", "[ir]") {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const Expr node(graph, build(*random_recipe(random, 5), graph, symbols, random));
    const Point point = random_point(random);
    Substitution numbers(graph);
    for (std::size_t i = 0; i < k_variables; ++i) {
      numbers.replace(symbols.variables[i], Expr(graph, graph.constant(point.variables[i])));
    }
    const Expr reduced = numbers(node);
    INFO("seed " << seed << ": " << print(graph, node.id()));
    REQUIRE(violations(graph, {reduced.id()}) == std::vector<std::string>{});
    const std::optional<Rational> expected = exact_value(graph, node.id(), symbols, point);
    if (expected) REQUIRE(exact_value(graph, reduced.id(), symbols, point) == expected);
  }
}

}  // namespace
