#pragma once
// What depends on parameters and constants alone is computed once, by `prepare` (architecture, decision 9).

#include <string>
#include <unordered_map>
#include <vector>

#include "ir/node_table.hpp"
#include "ir/substitute.hpp"

namespace gaussgen::passes {

using ir::Graph;
using ir::NodeId;
using ir::SymbolId;

/// A value that `prepare` computes and the functions read.
struct PreparedValue {
  SymbolId symbol;   ///< a parameter itself, or a new symbol that stands for `value`
  NodeId value;      ///< over parameters
  std::string name;  ///< wanted; empty for an anonymous term
};

/// Splits expressions into what `prepare` computes and the rest. Maximal parts are taken, also partial products and
/// partial sums: m r x becomes (m r) x. Parts that differ by a rational factor share a value if the factor is whole.
class PreparationSplit {
 public:
  /// `names`: names wanted for nodes, by NodeId::index; they also hold for what becomes a prepared value.
  PreparationSplit(Graph& graph, std::unordered_map<std::uint32_t, std::string> names);

  /// The same expression over prepared values and what varies.
  NodeId operator()(NodeId root);

  /// False for what depends on parameters and constants alone.
  bool varies(NodeId id);

  /// Makes the parameters in `root` prepared values and leaves the rest as it is: for what is computed once anyway.
  void touch(NodeId root);

  /// Those that `roots` (results of this split, or touched ones) use, in the order in which they came up.
  std::vector<PreparedValue> values_in(const std::vector<NodeId>& roots) const;

 private:
  struct Parts {
    std::vector<NodeId> constant;
    std::vector<NodeId> varying;
  };

  bool depends(NodeId id);
  NodeId prepared(NodeId id);
  NodeId rebuilt(NodeId id);
  NodeId rebuilt_sum(NodeId id);
  NodeId rebuilt_term(const ir::Rational& coefficient, NodeId node);
  NodeId rebuilt_product(NodeId id);
  NodeId known(NodeId id) const { return *memo_.find(id); }
  std::string name_of(NodeId id) const;
  Parts split_factors(NodeId product);
  /// Whether nothing in a node is prepared: then it is its own result.
  bool stays(const ir::Node& node);
  bool has_constant_factor(const ir::Node& node);
  NodeId relabelled(NodeId old, NodeId replacement);

  Graph& graph_;
  std::unordered_map<std::uint32_t, std::string> names_;
  ir::NodeTable<bool> varies_;
  ir::NodeTable<NodeId> memo_;
  ir::NodeTable<NodeId> prepared_;  ///< node over parameters -> the symbol that stands for it
  std::vector<PreparedValue> values_;
  ir::Substitution definitions_;  ///< of prepared values, for others that are made of them
};

/// For results of the split: what varies among their prepared values, and what could have been prepared in them. Empty
/// when sound.
std::vector<std::string> violations(const Graph& graph, const PreparationSplit& split,
                                    const std::vector<NodeId>& roots);

}  // namespace gaussgen::passes
