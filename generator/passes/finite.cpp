#include "passes/finite.hpp"

#include <algorithm>
#include <cstdint>

#include "ir/node_table.hpp"
#include "ir/traverse.hpp"
#include "passes/share.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;

namespace {

constexpr std::size_t k_at_once = 64;

/// Of some values, a bit for each: if that one is not finite, neither is this node; if so, it is a NaN.
struct Reach {
  std::uint64_t not_finite = 0;
  std::uint64_t nan = 0;
};

bool is_whole(const ir::Rational& value) { return support::is_integer(value); }

class Follower {
 public:
  Follower(const ir::Graph& graph, const std::vector<NodeId>& values) : graph_(graph) {
    ir::NodeSet seen;
    for (const NodeId signed_value : values) {
      const NodeId value = without_sign(signed_value);
      if (seen.contains(value)) continue;
      seen.insert(value);
      values_.push_back(value);
    }
    order_ = ir::post_order(graph, values_);
  }

  std::vector<NodeId> needed() {
    std::vector<NodeId> kept;
    for (std::size_t first = 0; first < values_.size(); first += k_at_once) {
      const std::size_t last = std::min(values_.size(), first + k_at_once);
      const std::uint64_t known = known_by_others(first, last);
      for (std::size_t i = first; i < last; ++i) {
        if ((known >> (i - first) & 1U) == 0) kept.push_back(values_[i]);
      }
    }
    return kept;
  }

 private:
  NodeId without_sign(NodeId id) const {
    while (is_trivial(graph_, id) && !graph_[id].children.empty()) id = graph_[id].children[0];
    return id;
  }

  /// Of the values from `first` on, those that cannot be other than finite where some other value is.
  std::uint64_t known_by_others(std::size_t first, std::size_t last) {
    ir::NodeTable<std::uint64_t> own;
    for (std::size_t i = first; i < last; ++i) own[values_[i]] = std::uint64_t{1} << (i - first);
    ir::NodeTable<Reach> reach;
    for (const NodeId id : order_) {
      Reach here = reach_of(graph_[id], reach);
      if (const std::uint64_t* bit = own.find(id)) here.not_finite |= *bit;
      reach[id] = here;
    }
    std::uint64_t known = 0;
    for (const NodeId value : values_) {
      const std::uint64_t* bit = own.find(value);
      known |= reach.find(value)->not_finite & ~(bit == nullptr ? 0 : *bit);
    }
    return known;
  }

  static Reach reach_of(const Node& node, const ir::NodeTable<Reach>& reach) {
    Reach below;
    for (const NodeId child : node.children) {
      const Reach& of_child = *reach.find(child);
      below.not_finite |= of_child.not_finite;
      below.nan |= of_child.nan;
    }
    switch (node.kind) {
      case Kind::sum:
      case Kind::product:
      case Kind::named: return below;  // ∞ - ∞ and 0 ∞ are NaN
      case Kind::power: return of_power(node, below);
      case Kind::function: return of_function(node.function, below);
      default: return {};
    }
  }

  static Reach of_power(const Node& node, const Reach& below) {
    if (!is_whole(2 * node.value)) return {};           // pow
    if (node.value < 0) return {below.nan, below.nan};  // 1/∞ = 0
    return below;
  }

  static Reach of_function(Function function, const Reach& below) {
    const bool is_circular = function == Function::sin || function == Function::cos;
    return is_circular ? Reach{below.not_finite, below.not_finite} : Reach{};
  }

  const ir::Graph& graph_;
  std::vector<NodeId> values_;
  std::vector<NodeId> order_;
};

}  // namespace

std::vector<NodeId> fewest_to_check(const ir::Graph& graph, const std::vector<NodeId>& values) {
  return Follower(graph, values).needed();
}

}  // namespace gaussgen::passes
