#include "ir/reverse.hpp"

#include <algorithm>

#include "ir/differentiate.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::ir {

Reverse::Reverse(Graph& graph, const std::vector<SymbolId>& symbols) : graph_(graph), symbols_(symbols) {
  for (std::size_t i = 0; i < symbols.size(); ++i) places_.emplace(symbols[i].index, i);
}

std::vector<Expr> Reverse::operator()(const std::vector<Weighted>& sum, const std::string& name) {
  std::vector<NodeId> roots;
  for (const Weighted& one : sum) roots.push_back(one.function.id());
  const std::vector<NodeId> order = post_order(graph_, roots);
  find_dependent(order);
  Contributions contributions;
  for (const Weighted& one : sum) add(one.function.id(), 1, one.weight.id(), contributions);
  std::vector<Expr> gradient(symbols_.size(), Expr(graph_, graph_.constant(0)));
  // Parents before children: whatever contributes to a node has done so when its turn comes.
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    const std::vector<Term>* const terms = contributions.find(*it);
    if (terms == nullptr) continue;
    const NodeId adjoint = graph_.linear(0, *terms);
    if (graph_.is_zero(adjoint)) continue;
    if (graph_[*it].kind == Kind::symbol) {
      gradient[places_.at(graph_[*it].symbol.index)] = {graph_, adjoint};
    } else {
      contribute(*it, kept(*it, adjoint, name), contributions);
    }
  }
  return gradient;
}

bool Reverse::depends(NodeId id) const {
  const bool* const found = dependent_.find(id);
  return found != nullptr && *found;
}

void Reverse::find_dependent(const std::vector<NodeId>& order) {
  for (const NodeId id : order) {
    if (dependent_.contains(id)) continue;
    const Node& node = graph_[id];
    bool found = node.kind == Kind::symbol && places_.count(node.symbol.index) != 0;
    for (const NodeId child : node.children) found = found || depends(child);
    dependent_[id] = found;
  }
}

void Reverse::add(NodeId child, const Rational& coefficient, NodeId part, Contributions& to) {
  if (depends(child)) to[child].push_back({coefficient, part});
}

// Where several children take their part of it, it is computed once.
NodeId Reverse::kept(NodeId id, NodeId adjoint, const std::string& name) {
  const Kind kind = graph_[id].kind;
  std::size_t takers = 0;
  for (const NodeId child : graph_[id].children) takers += depends(child) ? 1U : 0U;
  const Kind own = graph_[adjoint].kind;
  const bool costs = own == Kind::sum || own == Kind::product;
  if (!costs || (takers < 2 && kind != Kind::named)) return adjoint;
  const std::string& label = graph_.label(id);
  return graph_.kept_whole(adjoint, label.empty() ? name : name + "_" + label);
}

void Reverse::contribute(NodeId id, NodeId adjoint, Contributions& to) {
  const Node& node = graph_[id];
  switch (node.kind) {
    case Kind::sum:
      for (std::size_t i = 0; i < node.children.size(); ++i) add(node.children[i], node.coefficients[i], adjoint, to);
      return;
    case Kind::product:
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (!depends(node.children[i])) continue;
        std::vector<NodeId> factors = listed(node.children);
        factors[i] = adjoint;
        add(node.children[i], 1, graph_.product(factors), to);
      }
      return;
    case Kind::power:
      add(node.children[0], node.value, graph_.product({adjoint, graph_.power(node.children[0], node.value - 1)}), to);
      return;
    case Kind::named: add(node.children[0], 1, adjoint, to); return;
    case Kind::function:
      if (is_boolean(node.function)) return;
      if (node.function == Function::select || node.function == Function::piecewise) return add_choice(id, adjoint, to);
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        // Of f(x, x), the slope is that of both.
        const auto child = node.children.begin() + static_cast<std::ptrdiff_t>(i);
        if (!depends(*child) || std::find(node.children.begin(), child, *child) != child) continue;
        add(*child, 1, graph_.product({adjoint, slope({graph_, id}, i).id()}), to);
      }
      return;
    default: return;
  }
}

void Reverse::add_choice(NodeId id, NodeId adjoint, Contributions& to) {
  for (const NodeId below : post_order(graph_, {id})) {
    if (graph_[below].kind != Kind::symbol || !depends(below)) continue;
    const Expr slope = partial({graph_, id}, graph_[below].symbol);
    if (!slope.is_zero()) add(below, 1, graph_.product({adjoint, slope.id()}), to);
  }
}

}  // namespace gaussgen::ir
