#pragma once
// What one expression is worth inside of a program: the operations that only it needs.

#include "ir/node_table.hpp"
#include "passes/program.hpp"

namespace gaussgen::passes {

/// Uses of the nodes of a program, kept up while it is rewritten.
class Worth {
 public:
  Worth(const Graph& graph, const std::vector<NodeId>& order, const std::vector<NodeId>& outputs);

  /// `now` is part of the program in the place of `old`.
  void replace(NodeId old, NodeId now);

  /// Operations that end with it: of itself, and of what only it uses.
  int of(NodeId node) const;

  /// Operations that begin with it, where it is not part of the program yet.
  int of_new(NodeId node) const;

 private:
  template <class Stop>
  int operations(NodeId node, Stop stop) const;

  const Graph& graph_;
  ir::NodeTable<int> uses_;
};

}  // namespace gaussgen::passes
