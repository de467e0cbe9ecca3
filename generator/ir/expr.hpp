#pragma once
// Arithmetic notation for nodes, so that mechanics reads like mechanics.

#include <algorithm>

#include "ir/graph.hpp"

namespace gaussgen::ir {

/// A node together with its graph. Copies are cheap.
class Expr {
 public:
  Expr(Graph& graph, NodeId id) : graph_(&graph), id_(id) {}

  Graph& graph() const { return *graph_; }
  NodeId id() const { return id_; }
  bool is_zero() const { return graph_->is_zero(id_); }
  bool is_one() const { return graph_->is_one(id_); }

  friend Expr operator+(Expr a, Expr b) { return {*a.graph_, a.graph_->sum({a.id_, b.id_})}; }
  friend Expr operator-(Expr a, Expr b) { return {*a.graph_, a.graph_->linear(0, {{1, a.id_}, {-1, b.id_}})}; }
  friend Expr operator*(Expr a, Expr b) { return {*a.graph_, a.graph_->product({a.id_, b.id_})}; }
  friend Expr operator/(Expr a, Expr b) { return {*a.graph_, a.graph_->product({a.id_, a.graph_->power(b.id_, -1)})}; }
  friend Expr operator*(const Rational& factor, Expr a) { return {*a.graph_, a.graph_->scale(factor, a.id_)}; }
  friend Expr operator-(Expr a) { return Rational(-1) * a; }
  Expr& operator+=(Expr b) { return *this = *this + b; }
  Expr& operator-=(Expr b) { return *this = *this - b; }

  /// See Graph::named.
  Expr named(const std::string& name) const { return {*graph_, graph_->named(id_, name)}; }

  /// See Graph::kept_whole.
  Expr kept_whole(const std::string& name) const { return {*graph_, graph_->kept_whole(id_, name)}; }

  friend bool operator==(Expr a, Expr b) { return a.id_ == b.id_; }

 private:
  Graph* graph_;
  NodeId id_;
};

inline Expr pow(Expr base, const Rational& exponent) { return {base.graph(), base.graph().power(base.id(), exponent)}; }
inline Expr call(Function function, Expr argument) {
  return {argument.graph(), argument.graph().call(function, {argument.id()})};
}

/// Conditions are nodes as well: 0 and 1 where they are decided.
inline Expr less(Expr a, Expr b) { return {a.graph(), a.graph().call(Function::less, {a.id(), b.id()})}; }
inline Expr at_most(Expr a, Expr b) { return {a.graph(), a.graph().call(Function::at_most, {a.id(), b.id()})}; }
inline Expr select(Expr condition, Expr a, Expr b) {
  return {a.graph(), a.graph().call(Function::select, {condition.id(), a.id(), b.id()})};
}
/// Each of the conditions once; those of another `any` are among them.
inline Expr any(Graph& graph, const std::vector<Expr>& conditions) {
  std::vector<NodeId> open;
  const auto add = [&](NodeId id) {
    if (std::find(open.begin(), open.end(), id) == open.end()) open.push_back(id);
  };
  for (const Expr condition : conditions) {
    if (condition.is_one()) return condition;
    if (condition.is_zero()) continue;
    const Node& node = graph[condition.id()];
    if (node.kind == Kind::function && node.function == Function::any) {
      for (const NodeId child : node.children) add(child);
    } else {
      add(condition.id());
    }
  }
  if (open.empty()) return {graph, graph.constant(0)};
  return {graph, open.size() == 1 ? open[0] : graph.call(Function::any, open)};
}

}  // namespace gaussgen::ir
