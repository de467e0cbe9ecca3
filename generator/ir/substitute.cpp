#include "ir/substitute.hpp"

#include <algorithm>

#include "ir/rounded.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::ir {

void Substitution::replace(SymbolId symbol, Expr by) {
  replacements_.insert_or_assign(symbol.index, by.id());
  memo_.clear();
}

void Substitution::round_numbers() {
  rounds_ = true;
  memo_.clear();
}

Expr Substitution::operator()(Expr expression) {
  if (const NodeId* const found = memo_.find(expression.id())) return {graph_, *found};
  const auto is_known = [this](NodeId id) { return memo_.contains(id); };
  for (const NodeId id : post_order(graph_, {expression.id()}, is_known)) {
    if (!is_known(id)) memo_[id] = rebuilt(id);
  }
  return {graph_, *memo_.find(expression.id())};
}

NodeId Substitution::rebuilt(NodeId id) {
  const Node& node = graph_[id];
  if (node.kind == Kind::constant) return id;
  if (node.kind == Kind::symbol) {
    const auto found = replacements_.find(node.symbol.index);
    return found == replacements_.end() ? id : found->second;
  }
  const bool is_same = std::all_of(node.children.begin(), node.children.end(),
                                   [this](NodeId child) { return *memo_.find(child) == child; });
  if (is_same) return id;
  std::vector<NodeId> children;
  children.reserve(node.children.size());
  for (const NodeId child : node.children) children.push_back(*memo_.find(child));
  const std::string label = node.kind == Kind::named ? "" : graph_.label(id);
  const auto relabelled = [&](NodeId result) {
    if (rounds_) result = rounded({graph_, result}).id();
    return label.empty() ? result : graph_.named(result, label);
  };
  switch (node.kind) {
    case Kind::sum: {
      std::vector<Term> terms;
      for (std::size_t i = 0; i < children.size(); ++i) terms.push_back({node.coefficients[i], children[i]});
      return relabelled(graph_.linear(node.value, terms));
    }
    case Kind::product: return relabelled(graph_.product(children));
    case Kind::power: return relabelled(graph_.power(children[0], node.value));
    case Kind::function: return relabelled(graph_.call_again(node, children));
    case Kind::named: return graph_.named(children[0], graph_.name(node));
    default: return id;
  }
}

}  // namespace gaussgen::ir
