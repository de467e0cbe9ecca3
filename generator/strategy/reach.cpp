#include "strategy/reach.hpp"

#include <algorithm>
#include <vector>

#include "ir/traverse.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Function;
using ir::Kind;
using ir::Node;
using ir::NodeId;

std::optional<Expr> Reach::operator()(Expr e) {
  const Entry entry = found(e.id(), k_names);
  return entry.turns ? std::optional(Expr(graph_, entry.reach)) : std::nullopt;
}

bool Reach::is_turn(NodeId id) const {
  const Node& node = graph_[id];
  if (node.kind == Kind::symbol) return graph_.symbol(node.symbol).is_of_unit_quaternion;
  return node.kind == Kind::function && (node.function == Function::sin || node.function == Function::cos) &&
         !ir::is_of_parameters(graph_, id);
}

Reach::Entry Reach::found(NodeId id, std::size_t names) {
  if (const Entry* const known = found_[names].find(id)) return *known;
  const Entry entry = of(id, names);
  found_[names][id] = entry;
  return entry;
}

Reach::Entry Reach::of(NodeId id, std::size_t names) {
  if (is_turn(id)) return {true, graph_.constant(1)};
  const Entry whole{false, graph_.call(Function::abs, {id})};
  if (ir::is_of_parameters(graph_, id)) return whole;
  const Node node = graph_[id];
  Entry inside;
  switch (node.kind) {
    case Kind::named:
      if (names == 0) return whole;
      inside = found(node.children[0], names - 1);
      break;
    case Kind::sum: inside = of_sum(node, names); break;
    case Kind::product: inside = of_product(node, names); break;
    case Kind::power:
      if (node.value < 0) return whole;
      inside = found(node.children[0], names);
      inside.reach = graph_.power(inside.reach, node.value);
      break;
    default: return whole;
  }
  return inside.turns ? inside : whole;
}

Reach::Entry Reach::of_product(const Node& node, std::size_t names) {
  bool turns = false;
  std::vector<NodeId> factors;
  for (const NodeId factor : node.children) {
    const Entry entry = found(factor, names);
    turns = turns || entry.turns;
    factors.push_back(entry.reach);
  }
  return {turns, graph_.product(factors)};
}

Reach::Entry Reach::of_sum(const Node& node, std::size_t names) {
  std::vector<ir::Term> rest, terms;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Entry entry = found(node.children[i], names);
    if (entry.turns) {
      terms.push_back({cln::abs(node.coefficients[i]), entry.reach});
    } else {
      rest.push_back({node.coefficients[i], node.children[i]});
    }
  }
  const bool turns = !terms.empty();
  terms.push_back({1, graph_.call(Function::abs, {graph_.linear(node.value, rest)})});
  return {turns, graph_.linear(0, terms)};
}

}  // namespace gaussgen::strategy
