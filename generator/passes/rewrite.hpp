#pragma once
// What passes share that make a new graph of values from an old one.

#include <vector>

#include "ir/node_table.hpp"
#include "passes/program.hpp"

namespace gaussgen::passes {

/// The nodes below some roots, rebuilt children first. A pass says how a node becomes another one; names go with it.
class Rewrite {
 public:
  explicit Rewrite(Graph& graph) : graph_(graph) {}

  bool knows(NodeId old) const { return map_.contains(old); }
  NodeId operator()(NodeId old) const { return *map_.find(old); }

  /// `now` takes the place of `old`, and its name.
  void replace(NodeId old, NodeId now);

  /// The same operation over what took the places of the operands.
  NodeId rebuilt(NodeId old) const;

  /// What became of a request: nodes of sections that are no more are left out.
  Request operator()(const Request& request) const;

 private:
  Graph& graph_;
  ir::NodeTable<NodeId> map_;
};

/// A value that further simplification does not take apart, without a name of its own; a sign that most of its terms have
/// stands in front.
NodeId closed(Graph& graph, NodeId node);

/// A number that floating-point types hold as it is, but for its length.
bool is_binary(const ir::Rational& value);

/// x and n of x^n with a whole n; n = 1 for anything but a power.
struct Factor {
  NodeId base;
  int exponent = 1;
};

/// Of a product or power, by whole powers; of anything else, itself.
std::vector<Factor> factors_of(const Graph& graph, NodeId node);

}  // namespace gaussgen::passes
