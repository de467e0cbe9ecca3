#pragma once
// Hash-consed, canonically ordered expression graph: everything that is assembled, solved and emitted lives here.
//
// Invariants (checked by verify.hpp):
//  - a sum has no constant or sum among its children, no zero coefficient, children in canonical order, and is
//    neither a lone child with coefficient 1 nor a bare constant;
//  - a product has at least two factors, no constant, no product, no one-term sum, like bases merged; a sum among its
//    factors is primitive (coprime integer coefficients, leading one positive), the rest moved into a coefficient;
//  - what has no value whatever its symbols are (1/0, log 0) is never folded away: it absorbs what it is multiplied with
//    and stays in a sum in which it cancels;
//  - the order is built from declaration order and structure, never from addresses or creation order.

#include <boost/container/deque.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "ir/hash_index.hpp"
#include "ir/names.hpp"
#include "ir/node.hpp"
#include "ir/node_table.hpp"
#include "support/table.hpp"

namespace gaussgen::ir {

/// More have no use: the text of a function of this size is beyond what compilers take, and the memory beyond what most
/// machines have (some 4 GB).
inline constexpr std::size_t k_most_nodes = 5'000'000;

/// A graph has as many nodes as it may.
class TooManyNodes : public std::length_error {
 public:
  using std::length_error::length_error;
};

/// coefficient * node
struct Term {
  Rational coefficient;
  NodeId node;
};

class Graph {
 public:
  /// Throws TooManyNodes when it would have more than `most_nodes`, as its copies do.
  explicit Graph(std::size_t most_nodes = k_most_nodes) : most_nodes_(most_nodes) {}

  SymbolId declare(SymbolClass symbol_class, std::string name, bool is_of_unit_quaternion = false);
  const Symbol& symbol(SymbolId id) const { return symbols_[id.index]; }
  std::size_t symbol_count() const { return symbols_.size(); }

  TableId declare(std::shared_ptr<const support::Table> table);
  const support::Table& table(TableId id) const { return *tables_[id.index]; }
  std::size_t table_count() const { return tables_.size(); }

  NodeId constant(const Rational& value);
  NodeId use(SymbolId id);
  NodeId sum(const std::vector<NodeId>& terms);
  NodeId product(const std::vector<NodeId>& factors);
  /// The same in groups of factors and groups of groups, each kept whole, where there are many factors: a derivative of n factors
  /// written side by side has n terms of n factors, and a second one n² of them; of groups, it has n log n factors in all.
  NodeId product_in_groups(const std::vector<NodeId>& factors, const std::string& name);
  /// constant + Σ coefficient * node
  NodeId linear(const Rational& constant, const std::vector<Term>& terms);
  NodeId scale(const Rational& factor, NodeId node);
  NodeId power(NodeId base, const Rational& exponent);
  NodeId call(Function function, std::vector<NodeId> arguments);
  /// The derivative of `order` of a table; 0 beyond its degree.
  NodeId look_up(TableId table, int order, NodeId argument);
  /// The function of `node` at other arguments.
  NodeId call_again(const Node& node, std::vector<NodeId> arguments);

  /// `node` under a name that appears in emitted code. A sum (or anything that holds one) becomes opaque: later
  /// simplification does not flatten it, so it is computed once. A monomial only gets the label, since taking it
  /// apart costs nothing and lets factors cancel. The first name stays.
  NodeId named(NodeId node, const std::string& name);

  /// `node` under a name, opaque also where it is a monomial: its factors are multiplied before others join them, which
  /// matters where a product of some of them leaves the range of numbers.
  NodeId kept_whole(NodeId node, const std::string& name);

  /// Gives a node without a name one that says nothing to simplification.
  void relabel(NodeId node, const std::string& name);

  const Node& operator[](NodeId id) const { return nodes_[id.index]; }
  std::size_t size() const { return nodes_.size(); }

  /// Of a node of kind named, or empty. Stays valid.
  const std::string& name(const Node& node) const { return names_[node.name]; }

  /// The name that `named` gave, the first one when there were several; empty if none. Stays valid.
  const std::string& label(NodeId id) const;

  /// Canonical order: <0, 0, >0. Independent of the order in which nodes were created.
  int compare(NodeId a, NodeId b) const;

  bool is_constant(NodeId id, int value) const;
  /// No finite real value for any values of the symbols; see undefined.hpp.
  bool is_undefined(NodeId id) const { return undefined_[id.index]; }
  /// Whether some symbol in it changes between two evaluations with the same parameters.
  bool varies(NodeId id) const { return varies_[id.index]; }
  bool is_zero(NodeId id) const { return is_constant(id, 0); }
  bool is_one(NodeId id) const { return is_constant(id, 1); }

 private:
  // Blocks of a few hundred nodes: not one allocation for every three of them.
  using Nodes =
      boost::container::deque<Node, void, boost::container::deque_options<boost::container::block_size<256U>>::type>;

  NodeId intern(Node node);
  bool has_variable(const Node& node) const;
  NodeId grouped(const std::vector<NodeId>& factors, const std::string& name);
  /// The order of two different nodes, or nothing if it is that of two of their parts, to which this goes.
  std::optional<int> step_down(NodeId& a, NodeId& b) const;
  std::optional<NodeId> first_undefined(const std::vector<NodeId>& nodes) const;
  /// `terms` without repetitions and in canonical order.
  NodeId finish_sum(const Rational& constant, const std::vector<Term>& terms);

  std::size_t most_nodes_;
  std::vector<Symbol> symbols_;
  std::vector<std::shared_ptr<const support::Table>> tables_;
  Nodes nodes_;                  // references to nodes stay valid while the graph grows
  std::vector<bool> undefined_;  ///< parallel to nodes_
  std::vector<bool> varies_;     ///< likewise
  HashIndex index_;
  Names names_;
  NodeTable<NameId> labels_;
  NodeTable<NodeId> wrappers_;                             ///< value -> its named node
  mutable std::unordered_map<std::uint64_t, int> orders_;  ///< of pairs that were met deep down, lower index first
};

}  // namespace gaussgen::ir
