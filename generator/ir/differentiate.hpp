#pragma once

#include <string>
#include <unordered_map>
#include <utility>

#include "ir/expr.hpp"
#include "ir/symbol_sets.hpp"

namespace gaussgen::ir {

/// Derivative along a direction: Σ ∂f/∂s ṡ over the symbols s that have a seed ṡ. Every node is differentiated once.
/// The total time derivative is the direction {q: q̇, t: 1}, a partial derivative is {s: 1}.
class Directional {
 public:
  explicit Directional(Graph& graph) : graph_(graph) {}

  void seed(SymbolId symbol, Expr rate);

  /// The only symbol with a seed is that one of `sets`, which see at once what does not depend on it.
  void skip_others(SymbolSets& sets, std::size_t symbol) {
    sets_ = &sets;
    symbol_ = symbol;
  }

  /// From here on `value` has this rate, whatever it is made of: the solution of a linear system, whose rate is that of another one.
  /// After the seeds.
  void take(Expr value, Expr rate) { memo_[value.id()] = rate.id(); }

  /// Rates of named nodes are named, too, with this behind the name: what is shared in a function is shared in its derivatives, which
  /// are as many nodes as it has then, and not the square.
  void name_rates(std::string suffix) { suffix_ = std::move(suffix); }

  Expr operator()(Expr function);

 private:
  NodeId derivative(NodeId id);
  NodeId of_node(NodeId id);
  NodeId of_function(const Node& node);
  /// The rate of the child `first` where the condition holds, of the next one elsewhere.
  NodeId chosen(NodeId condition, const Node& node, std::size_t first);
  bool is_skipped(NodeId id) { return sets_ != nullptr && !sets_->depends(id, symbol_); }
  NodeId known(NodeId id) { return is_skipped(id) ? graph_.constant(0) : *memo_.find(id); }

  Graph& graph_;
  SymbolSets* sets_ = nullptr;
  std::size_t symbol_ = 0;  ///< in sets_
  std::string suffix_;      ///< of rates; empty: they have no names
  std::unordered_map<std::uint32_t, NodeId> seeds_;
  NodeTable<NodeId> memo_;
};

/// ∂f/∂s
Expr partial(Expr function, SymbolId symbol);

/// Of a function: its derivative by one of its arguments, the others kept.
Expr slope(Expr function, std::size_t child);

}  // namespace gaussgen::ir
