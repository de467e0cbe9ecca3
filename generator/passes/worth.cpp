#include "passes/worth.hpp"

#include "ir/cost.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::passes {

Worth::Worth(const Graph& graph, const std::vector<NodeId>& order, const std::vector<NodeId>& outputs) : graph_(graph) {
  for (const NodeId id : order) {
    for (const NodeId child : graph[id].children) ++uses_[child];
  }
  for (const NodeId id : outputs) ++uses_[id];
}

void Worth::replace(NodeId old, NodeId now) {
  if (old == now) return;
  const int* const uses = uses_.find(old);
  const int count = uses == nullptr ? 0 : *uses;
  uses_[now] += count;
}

template <class Stop>
int Worth::operations(NodeId node, Stop stop) const {
  const auto ends = [&](NodeId id) { return id != node && stop(id); };
  std::vector<NodeId> own;
  for (const NodeId id : ir::post_order(graph_, {node}, ends)) {
    if (!ends(id)) own.push_back(id);
  }
  return ir::operations_of(graph_, own);
}

int Worth::of(NodeId node) const {
  return operations(node, [&](NodeId id) {
    const int* const uses = uses_.find(id);
    return uses == nullptr || *uses > 1;
  });
}

int Worth::of_new(NodeId node) const {
  if (uses_.contains(node)) return 0;
  return operations(node, [&](NodeId id) { return uses_.contains(id); });
}

}  // namespace gaussgen::passes
