// raise(lower(e)) == e, in exact rationals. sin and cos are a rational point of the circle, with parameter the value of
// their argument: odd and even as they must be, and on the circle, so every identity that the graph may use holds.

#include <random>

#include "catch_shim.hpp"
#include "ir/print.hpp"
#include "ir/traverse.hpp"
#include "ir/verify.hpp"
#include "lower/lowering.hpp"
#include "lower/raise.hpp"
#include "support/assert.hpp"
#include "symbolic/choices.hpp"
#include "symbolic/rational.hpp"

using namespace gaussgen;
using GiNaC::ex;
using support::Rational;

namespace {

Rational call(ir::Function function, const Rational& x) {
  const Rational below = 1 + x * x;
  switch (function) {
    case ir::Function::sin: return 2 * x / below;
    case ir::Function::cos: return (1 - x * x) / below;
    case ir::Function::tan: return 2 * x / (1 - x * x);
    case ir::Function::exp: return 1 + x;
    default: FAIL("function " << ir::name_of(function)); return 0;
  }
}

Rational power(const Rational& base, const Rational& exponent) {
  const int e = support::to_int(exponent);
  return e < 0 ? Rational(1 / cln::expt_pos(base, -e)) : cln::expt_pos(base, e);
}

struct Fixture {
  Fixture() {
    pi = graph.declare(ir::SymbolClass::pi, "pi");
    for (const char* name : {"a", "b", "c", "d"}) {
      symbols.emplace_back(name);
      ids.push_back(graph.declare(ir::SymbolClass::configuration, name));
    }
  }

  ir::NodeId lower(const ex& e) {
    lower::Lowering lowering(graph, pi, [&](const GiNaC::symbol& symbol) {
      for (std::size_t i = 0; i < symbols.size(); ++i) {
        if (symbols[i].is_equal(symbol)) return graph.use(ids[i]);
      }
      FAIL("symbol " << symbol.get_name());
      return graph.constant(0);
    });
    return lowering(e);
  }

  ex raise(ir::NodeId id) {
    lower::Raising raising(graph, [&](ir::SymbolId symbol) -> ex { return symbols[symbol.index - 1]; });
    return raising(id);
  }

  Rational value(const ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) return symbolic::rational(GiNaC::ex_to<GiNaC::numeric>(e));
    if (GiNaC::is_a<GiNaC::power>(e)) return power(value(e.op(0)), value(e.op(1)));
    if (GiNaC::is_a<GiNaC::function>(e)) {
      const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
      for (const ir::Function f : {ir::Function::sin, ir::Function::cos, ir::Function::tan, ir::Function::exp}) {
        if (ir::name_of(f) == name) return call(f, value(e.op(0)));
      }
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
      for (std::size_t i = 0; i < symbols.size(); ++i) {
        if (symbols[i].is_equal(GiNaC::ex_to<GiNaC::basic>(e))) return numbers[i];
      }
    }
    const bool is_sum = GiNaC::is_a<GiNaC::add>(e);
    Rational result = is_sum ? 0 : 1;
    for (const ex& part : e) result = is_sum ? result + value(part) : result * value(part);
    return result;
  }

  Rational value(ir::NodeId root) {
    std::map<std::uint32_t, Rational> memo;
    for (const ir::NodeId id : ir::post_order(graph, {root})) {
      const ir::Node& node = graph[id];
      Rational result = node.value;
      const auto child = [&](std::size_t i) { return memo.at(node.children[i].index); };
      if (node.kind == ir::Kind::symbol) result = numbers[node.symbol.index - 1];
      if (node.kind == ir::Kind::product) result = 1;
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (node.kind == ir::Kind::sum) result = result + node.coefficients[i] * child(i);
        if (node.kind == ir::Kind::product) result = result * child(i);
      }
      if (node.kind == ir::Kind::power) result = power(child(0), node.value);
      if (node.kind == ir::Kind::function) result = call(node.function, child(0));
      memo[id.index] = result;
    }
    return memo.at(root.index);
  }

  ir::Graph graph;
  ir::SymbolId pi;
  std::vector<GiNaC::realsymbol> symbols;
  std::vector<ir::SymbolId> ids;
  std::vector<Rational> numbers{Rational(2) / 7, Rational(-3) / 5, Rational(11) / 13, Rational(5) / 3};
};

/// Random expressions of the kind that mechanics makes.
ex random_expression(std::mt19937& engine, const std::vector<GiNaC::realsymbol>& symbols, int depth) {
  const auto pick = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
  const auto sub = [&] { return random_expression(engine, symbols, depth - 1); };
  if (depth == 0)
    return pick(5) == 0 ? ex(GiNaC::numeric(pick(9) - 4, 1 + pick(4))) : ex(symbols[static_cast<std::size_t>(pick(4))]);
  switch (pick(6)) {
    case 0: return sub() + sub();
    case 1: return sub() - sub();
    case 2: return sub() * sub();
    case 3: return GiNaC::pow(sub(), 1 + pick(3));
    case 4: return GiNaC::sin(sub());
    default: return GiNaC::cos(sub()) * sub() + sub();
  }
}

}  // namespace

TEST_CASE("lowering keeps the value and raising gives it back, exactly", "[lower]") {
  std::mt19937 engine(1);
  for (int trial = 0; trial < 300; ++trial) {
    Fixture f;
    const ex e = random_expression(engine, f.symbols, 4);
    const ir::NodeId node = f.lower(e);
    INFO(ir::print(f.graph, node));
    CHECK(f.value(node) == f.value(e));
    CHECK(f.value(f.raise(node)) == f.value(e));
    CHECK(f.lower(f.raise(node)) == node);
    CHECK(ir::violations(f.graph, {node}).empty());
  }
}

TEST_CASE("signs that GiNaC flips from run to run come out one way", "[lower]") {
  Fixture f;
  const ex a = f.symbols[0], b = f.symbols[1];
  CHECK(f.lower(GiNaC::pow(2 * a - 2 * b, 3)) == f.lower(-8 * GiNaC::pow(b - a, 3)));
  CHECK(f.lower(GiNaC::sin(a - b)) == f.lower(-GiNaC::sin(b - a)));
  CHECK(f.lower(GiNaC::cos(a - b)) == f.lower(GiNaC::cos(b - a)));
  CHECK(f.lower((a - b) * (b - a)) == f.lower(-GiNaC::pow(a - b, 2)));
  CHECK(ir::print(f.graph, f.lower(1 / (b - a))) == "-(a - b)^(-1)");
}

TEST_CASE("pi, roots and inexact numbers", "[lower]") {
  Fixture f;
  CHECK(ir::print(f.graph, f.lower(2 * GiNaC::Pi * f.symbols[0])) == "2*pi*a");
  CHECK(ir::print(f.graph, f.lower(GiNaC::sqrt(ex(f.symbols[0])))) == "a^(1/2)");
  CHECK_THROWS_AS(f.lower(GiNaC::numeric(0.25) * f.symbols[0]), support::InternalError);
}

TEST_CASE("choices and tables go to the graph and back", "[lower]") {
  Fixture f;
  auto table = std::make_shared<support::Table>();
  table->name = "k";
  table->pieces = {{0, {1, 2, 3}}};
  f.graph.declare(table);
  const ex a = f.symbols[0], b = f.symbols[1];
  const ex wanted[] = {symbolic::abs_of(a),
                       symbolic::sign_of(a),
                       symbolic::min_of(a, b),
                       symbolic::max_of(b, a),
                       symbolic::case_less(a, b, GiNaC::log(a), b),
                       symbolic::case_at_most(a, 2, symbolic::case_less(b, 1, a, 0), b),
                       symbolic::table_at(0, 0, a + b),
                       symbolic::table_at(0, 2, a)};
  for (const ex& e : wanted) {
    const ir::NodeId node = f.lower(e);
    INFO(ir::print(f.graph, node));
    CHECK(f.raise(node).is_equal(e));
    CHECK(ir::violations(f.graph, {node}).empty());
  }
  CHECK(ir::print(f.graph, f.lower(wanted[5])) == "piecewise(at_most(a, 2), piecewise(less(b, 1), a, 0), b)");
  CHECK(ir::print(f.graph, f.lower(symbolic::abs_of(b - a))) == ir::print(f.graph, f.lower(symbolic::abs_of(a - b))));
  CHECK(ir::print(f.graph, f.lower(symbolic::table_at(0, 3, a))) == "0");
}
