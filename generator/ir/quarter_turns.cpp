#include "ir/quarter_turns.hpp"

#include <vector>

namespace gaussgen::ir {

namespace {

/// c π + rest
struct PartOfPi {
  Rational coefficient;
  NodeId rest;
};

bool is_pi(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  return node.kind == Kind::symbol && graph.symbol(node.symbol).symbol_class == SymbolClass::pi;
}

std::optional<PartOfPi> part_of_pi(Graph& graph, NodeId angle) {
  if (is_pi(graph, angle)) return PartOfPi{1, graph.constant(0)};
  const Node& node = graph[angle];
  if (node.kind != Kind::sum) return std::nullopt;
  std::optional<Rational> coefficient;
  std::vector<Term> others;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (is_pi(graph, node.children[i])) {
      coefficient = node.coefficients[i];
    } else {
      others.push_back({node.coefficients[i], node.children[i]});
    }
  }
  if (!coefficient) return std::nullopt;
  const Rational constant = node.value;
  return PartOfPi{*coefficient, graph.linear(constant, others)};
}

Rational modulo(const Rational& value, int period) { return value - period * cln::floor1(value / period); }

std::optional<Rational> rational_sine(const Rational& half_turns) {
  const Rational sixths = 6 * modulo(half_turns, 2);
  if (!support::is_integer(sixths)) return std::nullopt;
  switch (support::to_int(sixths)) {
    case 0:
    case 6: return 0;
    case 1:
    case 5: return Rational(1) / 2;
    case 3: return 1;
    case 7:
    case 11: return Rational(-1) / 2;
    case 9: return -1;
    default: return std::nullopt;
  }
}

std::optional<Rational> rational_tangent(const Rational& half_turns) {
  const Rational quarters = 4 * modulo(half_turns, 1);
  if (quarters == 0) return 0;
  if (quarters == 1) return 1;
  return quarters == 3 ? std::optional<Rational>(-1) : std::nullopt;
}

std::optional<Rational> rational_value(Function function, const Rational& half_turns) {
  if (function == Function::tan) return rational_tangent(half_turns);
  return rational_sine(function == Function::sin ? half_turns : half_turns + Rational(1) / 2);
}

/// sin(x + k π/2)
NodeId turned_sine(Graph& graph, int k, NodeId x) {
  const NodeId value = graph.call(k % 2 == 0 ? Function::sin : Function::cos, {x});
  return k % 4 < 2 ? value : graph.scale(-1, value);
}

}  // namespace

std::optional<NodeId> of_quarter_turns(Graph& graph, Function function, NodeId angle) {
  if (function != Function::sin && function != Function::cos && function != Function::tan) return std::nullopt;
  const auto part = part_of_pi(graph, angle);
  if (!part) return std::nullopt;
  if (graph.is_zero(part->rest)) {
    if (const auto value = rational_value(function, part->coefficient)) return graph.constant(*value);
  }
  const Rational quarters = modulo(2 * part->coefficient, 4);
  if (!support::is_integer(quarters)) return std::nullopt;
  const int k = support::to_int(quarters);
  if (function != Function::tan) return turned_sine(graph, function == Function::sin ? k : k + 1, part->rest);
  // A quarter further its poles are elsewhere, and are poles of a tangent to whoever is told of them.
  return k % 2 == 0 ? std::optional(graph.call(Function::tan, {part->rest})) : std::nullopt;
}

}  // namespace gaussgen::ir
