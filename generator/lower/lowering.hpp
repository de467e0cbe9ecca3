#pragma once
// GiNaC to the graph. GiNaC's order of terms, and even its signs, differ from process to process; the graph's
// constructors give every expression one form (architecture, decision 1).

#include <ginac/ginac.h>

#include <functional>
#include <map>

#include "ir/graph.hpp"

namespace gaussgen::lower {

class Lowering {
 public:
  /// What a symbol is; asked once for each.
  using Resolve = std::function<ir::NodeId(const GiNaC::symbol&)>;

  Lowering(ir::Graph& graph, ir::SymbolId pi, Resolve resolve) : graph_(graph), pi_(pi), resolve_(std::move(resolve)) {}

  ir::NodeId operator()(const GiNaC::ex& expression);

 private:
  ir::NodeId lowered(const GiNaC::ex& expression);
  ir::NodeId sum(const GiNaC::ex& expression);
  ir::NodeId power(const GiNaC::ex& expression);
  ir::NodeId call(const GiNaC::ex& expression);
  ir::NodeId table(const GiNaC::ex& expression);
  std::vector<ir::NodeId> operands(const GiNaC::ex& expression);

  ir::Graph& graph_;
  ir::SymbolId pi_;
  Resolve resolve_;
  std::map<GiNaC::ex, ir::NodeId, GiNaC::ex_is_less> memo_;  // looked up, never walked: its order is GiNaC's
};

}  // namespace gaussgen::lower
