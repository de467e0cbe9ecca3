#pragma once
// Graphs with much in common, as passes meet them: sums of products of what came before, reciprocals, sines.

#include <random>

#include "fixture.hpp"

namespace gausstest {

struct RandomGraph {
  explicit RandomGraph(unsigned seed, int size = 40) : source(seed) {
    for (const char* name : {"a", "b", "c", "d", "e"}) {
      pool.push_back(declare(graph, SymbolClass::configuration, name));
    }
    while (static_cast<int>(pool.size()) < size) pool.push_back(next());
    for (int i = 0; i < 6; ++i) outputs.push_back(pool[pool.size() - 1 - static_cast<std::size_t>(i)].id());
  }

  gaussgen::passes::Request request() const { return {outputs, {}, {}}; }

  Graph graph;
  std::vector<NodeId> outputs;

 private:
  Expr next() {
    switch (number(8)) {
      case 0: return pow(any() * any() + Expr(graph, graph.constant(3)), -1).named(name());
      case 1: return call(Function::sin, any());
      case 2: return call(Function::cos, any());
      case 3: return pow(any(), 2) * any();
      default: return term() + term() + term();
    }
  }

  // Some are kept whole, as the values that strategies name.
  Expr term() {
    const Expr product = gaussgen::ir::Rational(number(7) + 1) / (number(3) + 1) * (any() * any());
    const Expr signed_term = number(2) == 0 ? product : -product;
    return number(3) == 0 ? signed_term * any() : signed_term;
  }

  Expr any() {
    const Expr e = pool[static_cast<std::size_t>(number(static_cast<int>(pool.size())))];
    return number(4) == 0 ? e.named(name()) : e;
  }

  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(source); }
  std::string name() { return "n" + std::to_string(++names); }

  std::mt19937 source;
  std::vector<Expr> pool;
  int names = 0;
};

}  // namespace gausstest
