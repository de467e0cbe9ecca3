#include "strategy/reach.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Function;
using ir::Kind;
using ir::Node;
using ir::NodeId;

std::optional<Expr> Reach::operator()(Expr e) {
  for (const NodeId id : ir::post_order(graph_, {e.id()}, [this](NodeId known) { return found_.contains(known); })) {
    const Entry entry = of(id);
    found_[id] = entry;
  }
  return turns(e.id()) ? std::optional(known(e.id())) : std::nullopt;
}

bool Reach::is_turn(NodeId id) const {
  const Node& node = graph_[id];
  if (node.kind == Kind::symbol) return graph_.symbol(node.symbol).is_of_unit_quaternion;
  return node.kind == Kind::function && (node.function == Function::sin || node.function == Function::cos) &&
         !ir::is_of_parameters(graph_, id);
}

Reach::Entry Reach::of(NodeId id) {
  if (is_turn(id)) return {true, graph_.constant(1)};
  const Node node = graph_[id];
  const bool has_turn = std::any_of(node.children.begin(), node.children.end(), [&](NodeId c) { return turns(c); });
  const Entry whole{false, graph_.call(Function::abs, {id})};
  if (!has_turn) return whole;
  switch (node.kind) {
    case Kind::named: return {true, known(node.children[0]).id()};
    case Kind::sum: return {true, of_sum(node).id()};
    case Kind::product: {
      std::vector<NodeId> factors;
      for (const NodeId factor : node.children) factors.push_back(known(factor).id());
      return {true, graph_.product(factors)};
    }
    case Kind::power:
      return node.value > 0 ? Entry{true, graph_.power(known(node.children[0]).id(), node.value)} : whole;
    default: return whole;
  }
}

Expr Reach::of_sum(const Node& node) {
  std::vector<ir::Term> rest, terms;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (turns(node.children[i])) {
      terms.push_back({cln::abs(node.coefficients[i]), known(node.children[i]).id()});
    } else {
      rest.push_back({node.coefficients[i], node.children[i]});
    }
  }
  terms.push_back({1, graph_.call(Function::abs, {graph_.linear(node.value, rest)})});
  return {graph_, graph_.linear(0, terms)};
}

}  // namespace gaussgen::strategy
