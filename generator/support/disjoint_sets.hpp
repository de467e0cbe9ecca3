#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace gaussgen::support {

/// Of 0, 1, ... n-1: each alone at first.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// A member that stands for the set of i.
  std::size_t of(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }

  void join(std::size_t i, std::size_t j) { parent_[of(i)] = of(j); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace gaussgen::support
