#pragma once
// Derivatives of few functions by many symbols: one walk from the functions down to the symbols, with what each node contributes.

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ir/expr.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::ir {

/// A function with its weight in a sum of which the derivatives are taken; weights are constant.
struct Weighted {
  Expr function;
  Expr weight;
};

/// Reverse accumulation: the adjoint of a node is the derivative of the sum by it. Adjoints of what is shared are shared, so that all
/// derivatives together are some times as many nodes as the functions, whatever the number of symbols.
class Reverse {
 public:
  Reverse(Graph& graph, const std::vector<SymbolId>& symbols);

  /// Σ weight ∂function/∂s of each symbol s; shared adjoints are called <name>_<what they are of>.
  std::vector<Expr> operator()(const std::vector<Weighted>& sum, const std::string& name);

 private:
  using Contributions = NodeTable<std::vector<Term>>;

  bool depends(NodeId id) const;
  void find_dependent(const std::vector<NodeId>& order);
  /// To the children of a node with this adjoint.
  void contribute(NodeId id, NodeId adjoint, Contributions& to);
  void add(NodeId child, const Rational& coefficient, NodeId part, Contributions& to);
  /// A choice may leave out what has no value, which no factor 0 makes harmless: it is differentiated forwards, and then chosen.
  void add_choice(NodeId id, NodeId adjoint, Contributions& to);
  NodeId kept(NodeId id, NodeId adjoint, const std::string& name);

  Graph& graph_;
  std::vector<SymbolId> symbols_;
  std::unordered_map<std::uint32_t, std::size_t> places_;  ///< of symbols in the list
  NodeTable<bool> dependent_;
};

}  // namespace gaussgen::ir
