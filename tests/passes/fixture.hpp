#pragma once

#include <string>
#include <vector>

#include "ir/expr.hpp"
#include "passes/program.hpp"
#include "passes/schedule.hpp"
#include "passes/share.hpp"

namespace gausstest {

using gaussgen::ir::Expr;
using gaussgen::ir::Function;
using gaussgen::ir::Graph;
using gaussgen::ir::NodeId;
using gaussgen::ir::SymbolClass;

inline Expr declare(Graph& graph, SymbolClass symbol_class, const std::string& name) {
  return {graph, graph.use(graph.declare(symbol_class, name))};
}

inline gaussgen::passes::Program program_of(Graph& graph, const gaussgen::passes::Request& request) {
  const gaussgen::passes::Writing writing(graph, request.outputs);
  return schedule(writing, share(writing, request), request);
}

/// The temporaries in order.
inline std::vector<NodeId> temporaries(const gaussgen::passes::Program& program) {
  std::vector<NodeId> found;
  for (const auto& block : program.blocks) {
    for (const auto& assignment : block.assignments) {
      found.push_back(assignment.node);
      if (assignment.cosine) found.push_back(*assignment.cosine);
    }
  }
  return found;
}

inline bool contains(const std::vector<NodeId>& list, Expr node) {
  for (const NodeId id : list) {
    if (id == node.id()) return true;
  }
  return false;
}

}  // namespace gausstest
