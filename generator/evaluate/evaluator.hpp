#pragma once
// Interprets the expression graph in any number type for which there is an Arithmetic.

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "evaluate/arithmetic.hpp"
#include "ir/graph.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::evaluate {

/// Why a value is undefined: the first node on the way to it that failed, by its name in the model or its text.
struct Trouble {
  ir::NodeId node;
  std::string name;
  std::string reason;
};

/// Values of nodes for the symbols bound at the time; each node is computed once per binding.
///
/// pi and epsilon have the values of the type unless they are bound. An undefined value makes what uses it undefined,
/// except that `select` and `piecewise` look at the chosen branch only, `any` may be decided by another argument, and `not_finite`
/// is true for it. Instances for double, long double, cln::cl_F, Scaled<> of these and Paired are in evaluator.cpp.
template <class T>
class Evaluator {
 public:
  Evaluator(const ir::Graph& graph, Arithmetic<T> arithmetic) : graph_(graph), arithmetic_(std::move(arithmetic)) {}

  const Arithmetic<T>& arithmetic() const { return arithmetic_; }

  /// Gives a symbol its value, or another one.
  void bind(ir::SymbolId symbol, T value);

  /// The value of a node; empty if it is undefined, see `trouble`.
  std::optional<T> operator()(ir::NodeId node);
  std::vector<std::optional<T>> evaluate(const std::vector<ir::NodeId>& nodes);

  /// What made a node undefined; empty if it has a value.
  std::optional<Trouble> trouble(ir::NodeId node);

 private:
  struct Entry {
    std::optional<T> value;
    ir::NodeId origin;  ///< of the undefined
    const char* reason = "";
  };

  void compute(const std::vector<ir::NodeId>& nodes);
  /// Of one that is computed.
  std::optional<T> handed_out(ir::NodeId node) const;
  Entry entry_of(ir::NodeId id) const;
  Entry of_symbol(ir::NodeId id) const;
  Entry of_condition(ir::NodeId id) const;
  Outcome<T> of_values(const ir::Node& node, const std::vector<T>& x) const;
  /// abs, sign, min, max
  Outcome<T> chosen(ir::Function function, const std::vector<T>& x) const;
  Outcome<T> looked_up(const ir::Node& node, const T& x) const;
  const Entry& known(ir::NodeId id) const { return *entries_.find(id); }
  const Entry* first_undefined(const ir::Node& node) const;
  Entry boolean(bool value) const;

  const ir::Graph& graph_;
  Arithmetic<T> arithmetic_;
  std::unordered_map<std::uint32_t, T> bound_;
  ir::NodeTable<Entry> entries_;
};

}  // namespace gaussgen::evaluate
