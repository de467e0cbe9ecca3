#pragma once
// Walks over the graph without recursion, since its depth grows with the model.

#include <vector>

#include "ir/graph.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::ir {

/// All nodes below `roots` (roots included), each once, children before parents, in an order that depends on structure
/// only. With `stop(node)` true the children of a node are not visited. The cost follows the nodes visited.
template <class Stop>
std::vector<NodeId> post_order(const Graph& graph, const std::vector<NodeId>& roots, Stop stop) {
  enum class Mark : char { unseen, open, done };
  NodeTable<Mark> marks;
  std::vector<NodeId> order;
  std::vector<NodeId> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const NodeId id = stack.back();
    Mark& mark = marks[id];
    if (mark == Mark::unseen) {
      mark = Mark::open;
      if (stop(id)) continue;
      const Children& children = graph[id].children;
      for (auto it = children.rbegin(); it != children.rend(); ++it) {
        if (!marks.contains(*it)) stack.push_back(*it);
      }
    } else {
      stack.pop_back();
      if (mark == Mark::open) {
        mark = Mark::done;
        order.push_back(id);
      }
    }
  }
  return order;
}

inline std::vector<NodeId> post_order(const Graph& graph, const std::vector<NodeId>& roots) {
  return post_order(graph, roots, [](NodeId) { return false; });
}

/// Those nodes of `order` (children first) that depend on a symbol for which `is_variable` holds.
template <class IsVariable>
NodeSet depends_on(const Graph& graph, const std::vector<NodeId>& order, IsVariable is_variable) {
  NodeSet depends;
  for (const NodeId id : order) {
    const Node& node = graph[id];
    bool found = node.kind == Kind::symbol && is_variable(graph.symbol(node.symbol));
    for (const NodeId child : node.children) found = found || depends.contains(child);
    if (found) depends.insert(id);
  }
  return depends;
}

/// Parameters and numbers only.
inline bool is_of_parameters(const Graph& graph, NodeId id) { return !graph.varies(id); }

}  // namespace gaussgen::ir
