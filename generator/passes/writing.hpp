#pragma once
// How a node is written in code, so that sharing counts what will really be computed: x^5 is x * x4, not a power.

#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ir/latency.hpp"

namespace gaussgen::passes {

using ir::Graph;
using ir::NodeId;

struct PowerForm {
  enum class Kind {
    factors,      ///< product of the operands
    reciprocal,   ///< 1 / operand
    square_root,  ///< of the operand
    general,      ///< pow(operand, exponent)
  };
  Kind kind = Kind::general;
  ir::Children operands;
};

/// The nodes below some roots as they will be written. Powers that occur only in the writing of others (x^2 for x^3) are
/// added to the graph.
class Writing {
 public:
  Writing(Graph& graph, const std::vector<NodeId>& roots);

  const Graph& graph() const { return graph_; }

  /// What the written form of a node mentions, with repetitions.
  const ir::Children& operands(NodeId id) const;
  const PowerForm& power_form(NodeId power) const { return forms_.at(power.index); }

  /// When a node can be there: see ir/latency.hpp.
  int ready(NodeId id) const {
    const int* const found = ready_.find(id);
    return found == nullptr ? 0 : *found;
  }

  /// Every node once, operands first; depends on structure only.
  const std::vector<NodeId>& order() const { return order_; }
  bool contains(NodeId id) const { return reached_.count(id.index) != 0; }

 private:
  void walk(const std::vector<NodeId>& roots);
  void decompose(NodeId id);
  PowerForm form_of(NodeId power);
  ir::Children choice_of(NodeId id) const;
  PowerForm integer_power(NodeId base, int exponent);

  Graph& graph_;
  std::unordered_set<std::uint32_t> inverted_;  ///< bases x whose 1/x is wanted anyway
  std::unordered_map<std::uint32_t, PowerForm> forms_;
  std::unordered_map<std::uint32_t, ir::Children> choices_;  ///< operands of abs to piecewise
  std::unordered_set<std::uint32_t> reached_;
  std::vector<NodeId> order_;
  ir::NodeTable<int> ready_;
};

}  // namespace gaussgen::passes
