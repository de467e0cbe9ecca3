#include "ir/symbol_sets.hpp"

#include "ir/traverse.hpp"

namespace gaussgen::ir {

namespace {

constexpr std::size_t k_word = 64;

}  // namespace

SymbolSets::SymbolSets(const Graph& graph, const std::vector<SymbolId>& symbols)
    : graph_(graph), none_((symbols.size() + k_word - 1) / k_word, 0), all_(none_.size(), ~std::uint64_t{0}) {
  for (const SymbolId symbol : symbols) places_.emplace(symbol.index, places_.size());
}

bool SymbolSets::depends(NodeId id, std::size_t symbol) {
  return (sets_[set_of(id)][symbol / k_word] >> symbol % k_word & 1U) != 0;
}

SymbolSets::SetIndex SymbolSets::set_of(NodeId root) {
  if (const SetIndex* known = known_.find(root)) return *known;
  for (const NodeId id : post_order(graph_, {root}, [this](NodeId id) { return known_.contains(id); })) {
    if (!known_.contains(id)) known_[id] = found(id);
  }
  return *known_.find(root);
}

/// From those of its children.
SymbolSets::SetIndex SymbolSets::found(NodeId id) {
  const Node& node = graph_[id];
  if (graph_.is_undefined(id)) return kept(all_);
  Set set = none_;
  if (node.kind == Kind::symbol) {
    const auto place = places_.find(node.symbol.index);
    if (place != places_.end()) set[place->second / k_word] |= std::uint64_t{1} << place->second % k_word;
  }
  for (const NodeId child : node.children) {
    const Set& part = sets_[*known_.find(child)];
    for (std::size_t i = 0; i < set.size(); ++i) set[i] |= part[i];
  }
  return kept(std::move(set));
}

SymbolSets::SetIndex SymbolSets::kept(Set set) {
  const auto [place, is_new] = index_.emplace(std::move(set), static_cast<SetIndex>(sets_.size()));
  if (is_new) sets_.push_back(place->first);
  return place->second;
}

}  // namespace gaussgen::ir
