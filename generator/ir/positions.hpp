#pragma once
// Where nodes stand in a list that is being made: most lists are short.

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <utility>

#include "ir/node.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::ir {

class Positions {
 public:
  /// Where `id` is, and whether it is new there: at the end, then.
  std::pair<std::size_t, bool> emplace(NodeId id) {
    if (nodes_.size() <= k_few) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i] == id) return {i, false};
      }
    } else if (const std::uint32_t* const place = places_.find(id)) {
      return {*place, false};
    }
    nodes_.push_back(id);
    if (nodes_.size() == k_few + 1) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) places_[nodes_[i]] = static_cast<std::uint32_t>(i);
    } else if (nodes_.size() > k_few) {
      places_[id] = static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    return {nodes_.size() - 1, true};
  }

 private:
  static constexpr std::size_t k_few = 12;  ///< to look through

  boost::container::small_vector<NodeId, k_few> nodes_;
  NodeTable<std::uint32_t> places_;  ///< of all, once they are many
};

}  // namespace gaussgen::ir
