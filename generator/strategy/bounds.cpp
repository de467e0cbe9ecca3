#include "strategy/bounds.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Kind;
using ir::Node;
using ir::NodeId;
using support::Rational;

std::optional<Expr> Bounds::operator()(NodeId id) {
  for (const NodeId each : ir::post_order(graph_, {id}, [this](NodeId known) { return found_.contains(known); })) {
    const std::optional<Expr> bound = of(each);
    found_[each] = bound;
  }
  return *found_.find(id);
}

std::optional<Expr> Bounds::of(NodeId id) {
  if (ir::is_of_parameters(graph_, id)) return call(ir::Function::abs, Expr(graph_, id));
  const Node node = graph_[id];
  switch (node.kind) {
    case Kind::named: return *found_.find(node.children[0]);
    case Kind::sum: return of_sum(node);
    case Kind::product: return of_product(node);
    case Kind::power: return of_power(node);
    case Kind::function:
      if (node.function == ir::Function::sin || node.function == ir::Function::cos) return number(1);
      return std::nullopt;
    default: return std::nullopt;
  }
}

std::optional<Expr> Bounds::of_sum(const Node& node) {
  Expr result = number(cln::abs(node.value));
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const std::optional<Expr>& term = *found_.find(node.children[i]);
    if (!term) return std::nullopt;
    result += cln::abs(node.coefficients[i]) * *term;
  }
  return result;
}

std::optional<Expr> Bounds::of_product(const Node& node) {
  Expr result = number(1);
  for (const NodeId child : node.children) {
    const std::optional<Expr>& factor = *found_.find(child);
    if (!factor) return std::nullopt;
    result = result * *factor;
  }
  return result;
}

std::optional<Expr> Bounds::of_power(const Node& node) {
  const std::optional<Expr>& base = *found_.find(node.children[0]);
  return base && node.value > 0 ? std::optional<Expr>(pow(*base, node.value)) : std::nullopt;
}

std::optional<Expr> bound_of(Expr e) { return Bounds(e.graph())(e.id()); }

bool Addition::drowns(const std::function<double(Expr)>& estimate) const {
  constexpr double k_most = 100;
  return !added.is_zero() && !before.is_zero() && !(estimate(added / before) <= k_most);
}

Matrix bounds_of(const Matrix& entries) {
  Matrix result;
  for (const Vector& row : entries) {
    result.emplace_back();
    for (const Expr entry : row) result.back().push_back(bound_of(entry).value_or(call(ir::Function::abs, entry)));
  }
  return result;
}

bool is_number(Expr e) {
  const ir::Graph& graph = e.graph();
  const std::vector<NodeId> order = ir::post_order(graph, {e.id()});
  return std::all_of(order.begin(), order.end(), [&](NodeId id) {
    return graph[id].kind != Kind::symbol || graph.symbol(graph[id].symbol).symbol_class == ir::SymbolClass::pi;
  });
}

}  // namespace gaussgen::strategy
