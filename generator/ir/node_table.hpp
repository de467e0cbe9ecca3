#pragma once
// Values and marks for some of the nodes of a graph, at a cost that follows those nodes and not the whole graph.

#include <cstdint>
#include <utility>
#include <vector>

#include "ir/node.hpp"

namespace gaussgen::ir {

/// A map from nodes to values (open addressing). It has no iteration order, so none can leak into output.
template <class Value>
class NodeTable {
 public:
  /// The value of `id`, or null. Valid until the next insertion.
  const Value* find(NodeId id) const {
    if (slots_.empty()) return nullptr;
    const Slot& slot = slots_[place_of(id)];
    return slot.key == k_free ? nullptr : &slot.value;
  }
  Value* find(NodeId id) { return const_cast<Value*>(std::as_const(*this).find(id)); }

  bool contains(NodeId id) const { return find(id) != nullptr; }
  std::size_t size() const { return used_; }

  /// The value of `id`, made by default if there was none. Valid until the next insertion.
  Value& operator[](NodeId id) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[place_of(id)];
    if (slot.key == k_free) {
      slot.key = id.index;
      ++used_;
    }
    return slot.value;
  }

  void clear() {
    slots_.clear();
    used_ = 0;
  }

 private:
  static constexpr std::uint32_t k_free = 0xFFFFFFFFU;
  static constexpr std::uint32_t k_group_bits = 3;
  static constexpr std::uint32_t k_in_group = (1U << k_group_bits) - 1;

  struct Slot {
    std::uint32_t key = k_free;
    Value value{};
  };

  /// Where `id` is, or where it would go.
  std::size_t place_of(NodeId id) const {
    const std::size_t mask = slots_.size() - 1;
    // Nodes that are made together are looked up together: eight neighbours stay in one line of the cache, and Knuth's multiplier spreads
    // these groups, so that long runs of ids do not meet.
    const std::uint32_t group = (id.index >> k_group_bits) * 2654435769U >> 7U;
    std::size_t place = (std::size_t{group} << k_group_bits | (id.index & k_in_group)) & mask;
    while (slots_[place].key != k_free && slots_[place].key != id.index) place = (place + 1) & mask;
    return place;
  }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 32 : 2 * slots_.size());
    std::swap(old, slots_);
    for (Slot& slot : old) {
      if (slot.key != k_free) slots_[place_of(NodeId{slot.key})] = std::move(slot);
    }
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

/// A set of nodes.
class NodeSet {
 public:
  void insert(NodeId id) { table_[id] = true; }
  bool contains(NodeId id) const { return table_.contains(id); }
  std::size_t size() const { return table_.size(); }

 private:
  NodeTable<bool> table_;
};

}  // namespace gaussgen::ir
