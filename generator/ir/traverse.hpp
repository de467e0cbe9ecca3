#pragma once
// Walks over the graph without recursion, since its depth grows with the model.

#include <vector>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// All nodes below `roots` (roots included), each once, children before parents, in an order that depends on structure
/// only. With `stop(node)` true the children of a node are not visited.
template <class Stop>
std::vector<NodeId> post_order(const Graph& graph, const std::vector<NodeId>& roots, Stop stop) {
  enum : char { unseen, open, done };
  std::vector<char> state(graph.size(), unseen);
  std::vector<NodeId> order;
  std::vector<NodeId> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const NodeId id = stack.back();
    char& mark = state[id.index];
    if (mark == unseen) {
      mark = open;
      if (stop(id)) continue;
      const std::vector<NodeId>& children = graph[id].children;
      for (auto it = children.rbegin(); it != children.rend(); ++it) {
        if (state[it->index] == unseen) stack.push_back(*it);
      }
    } else {
      stack.pop_back();
      if (mark == open) {
        mark = done;
        order.push_back(id);
      }
    }
  }
  return order;
}

inline std::vector<NodeId> post_order(const Graph& graph, const std::vector<NodeId>& roots) {
  return post_order(graph, roots, [](NodeId) { return false; });
}

/// For every node of `order` (children first): does it depend on a symbol for which `is_variable` holds?
template <class IsVariable>
std::vector<char> depends_on(const Graph& graph, const std::vector<NodeId>& order, IsVariable is_variable) {
  std::vector<char> depends(graph.size(), 0);
  for (const NodeId id : order) {
    const Node& node = graph[id];
    if (node.kind == Kind::symbol) depends[id.index] = is_variable(graph.symbol(node.symbol)) ? 1 : 0;
    for (const NodeId child : node.children) {
      if (depends[child.index] != 0) depends[id.index] = 1;
    }
  }
  return depends;
}

/// True for what changes between two evaluations with the same parameters.
inline bool varies(const Symbol& symbol) {
  return symbol.symbol_class != SymbolClass::pi && symbol.symbol_class != SymbolClass::epsilon &&
         symbol.symbol_class != SymbolClass::parameter;
}

}  // namespace gaussgen::ir
