#pragma once
// Which nodes have a hash: the look-up behind hash-consing.

#include <cstdint>
#include <utility>
#include <vector>

#include "ir/node.hpp"

namespace gaussgen::ir {

/// Nodes by the hash of what they are (open addressing). It has no iteration order, so none can leak into output.
class HashIndex {
 public:
  /// The first node with this hash that `is_same` accepts, or null. Valid until the next insertion.
  template <class IsSame>
  const NodeId* find(std::uint32_t hash, IsSame is_same) const {
    if (slots_.empty()) return nullptr;
    for (std::size_t place = hash & mask(); slots_[place].node != k_free; place = (place + 1) & mask()) {
      if (slots_[place].hash == hash && is_same(slots_[place].node)) return &slots_[place].node;
    }
    return nullptr;
  }

  void insert(std::uint32_t hash, NodeId node) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    ++used_;
    slots_[free_place(hash)] = {hash, node};
  }

 private:
  static constexpr NodeId k_free{0xFFFFFFFFU};

  struct Slot {
    std::uint32_t hash = 0;
    NodeId node = k_free;
  };

  std::size_t mask() const { return slots_.size() - 1; }

  std::size_t free_place(std::uint32_t hash) const {
    std::size_t place = hash & mask();
    while (slots_[place].node != k_free) place = (place + 1) & mask();
    return place;
  }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 1024 : 2 * slots_.size());
    std::swap(old, slots_);
    for (const Slot& slot : old) {
      if (slot.node != k_free) slots_[free_place(slot.hash)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace gaussgen::ir
