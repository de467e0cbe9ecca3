#pragma once
// Which of many symbols each node depends on, so that a derivative by one of them visits only what it changes.

#include <cstdint>
#include <map>
#include <vector>

#include "ir/graph.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::ir {

/// Finds the set of a node when it is asked for. Equal sets are kept once: in a mechanism there are few.
class SymbolSets {
 public:
  SymbolSets(const Graph& graph, const std::vector<SymbolId>& symbols);

  /// What has no value depends on everything: its derivative is not zero.
  bool depends(NodeId id, std::size_t symbol);

 private:
  using Set = std::vector<std::uint64_t>;
  using SetIndex = std::uint32_t;

  SetIndex set_of(NodeId id);
  SetIndex found(NodeId id);
  SetIndex kept(Set set);

  const Graph& graph_;
  std::map<std::uint32_t, std::size_t> places_;  ///< of symbols in the sets
  Set none_, all_;
  std::vector<Set> sets_;
  std::map<Set, SetIndex> index_;
  NodeTable<SetIndex> known_;
};

}  // namespace gaussgen::ir
