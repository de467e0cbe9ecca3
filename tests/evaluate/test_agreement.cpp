// double, long double and CLN on random graphs: they differ by what the absolute sums allow.

#include <cmath>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/evaluator.hpp"
#include "ir/cost.hpp"
#include "ir/print.hpp"
#include "ir/recipe.hpp"

namespace {

using namespace gauss_test;
using namespace gaussgen::evaluate;
using cln::cl_F;
using gaussgen::ir::Graph;
using gaussgen::ir::NodeId;

/// The same random point in every type, exactly.
struct Evaluators {
  explicit Evaluators(const Graph& graph)
      : in_double(graph, {}),
        in_long(graph, {}),
        in_cln(graph, Arithmetic<cl_F>(50)),
        scales(graph, Arithmetic<Scaled<double>>(Arithmetic<double>())) {}

  void bind(SymbolId symbol, double value) {
    in_double.bind(symbol, value);
    in_long.bind(symbol, value);
    in_cln.bind(symbol, in_cln.arithmetic().number(value));
    scales.bind(symbol, scales.arithmetic().input(value));
  }

  Evaluator<double> in_double;
  Evaluator<long double> in_long;
  Evaluator<cl_F> in_cln;
  Evaluator<Scaled<double>> scales;
};

void bind_all(Evaluators& evaluators, const Symbols& symbols, Random& random) {
  for (const auto* list : {&symbols.variables, &symbols.angles}) {
    for (const SymbolId symbol : *list) {
      evaluators.bind(symbol, gaussgen::support::to_double(random.rational() + Rational(1) / 7));
    }
  }
}

double error(const Rational& approximation, const cl_F& reference) {
  return std::fabs(cln::double_approx(cln::cl_float(approximation, reference) - reference));
}

/// Compares on random expressions; returns how many values there were to compare.
int compare(RecipePtr (*make)(Random&, int), double units_per_operation) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    Graph graph;
    const Symbols symbols = declare_symbols(graph, random);
    const NodeId node = build(*make(random, 4), graph, symbols, random);
    Evaluators evaluators(graph);
    bind_all(evaluators, symbols, random);
    const auto reference = evaluators.in_cln(node);
    const auto scale = evaluators.scales(node);
    if (!reference || !scale) continue;
    const double operations = 1 + gaussgen::ir::count_operations(graph, {node}, true).total();
    const double allowed = units_per_operation * operations * scale->scale;
    INFO("seed " << seed << ": " << print(graph, node));
    const auto value = evaluators.in_double(node);
    REQUIRE(value.has_value());
    CHECK(error(exact(*value), *reference) <= allowed * 0x1p-53);
    const auto long_value = evaluators.in_long(node);
    REQUIRE(long_value.has_value());
    CHECK(error(exact(*long_value), *reference) <= allowed * 0x1p-64);
    ++compared;
  }
  return compared;
}

TEST_CASE("double and long double agree with CLN within the absolute sums", "[evaluate]") {
  CHECK(compare(random_recipe, 2) > 700);
  CHECK(compare(random_analytic_recipe, 2) > 400);
}

}  // namespace
