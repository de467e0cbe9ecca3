#pragma once

#include <unordered_map>

#include "ir/expr.hpp"

namespace gaussgen::ir {

/// Replaces symbols by expressions and simplifies again on the way up. Names survive.
class Substitution {
 public:
  explicit Substitution(Graph& graph) : graph_(graph) {}

  void replace(SymbolId symbol, Expr by);
  /// From now on numbers that come out have no more digits than `rounded` leaves: those of a table would have hundreds.
  void round_numbers();
  Expr operator()(Expr expression);

 private:
  NodeId rebuilt(NodeId id);

  Graph& graph_;
  bool rounds_ = false;
  std::unordered_map<std::uint32_t, NodeId> replacements_;
  NodeTable<NodeId> memo_;
};

}  // namespace gaussgen::ir
