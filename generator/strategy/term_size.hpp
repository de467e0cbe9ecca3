#pragma once
// How large the terms are that an expression is the sum of: rounding of these is what is left where they cancel.

#include "strategy/bounds.hpp"

namespace gaussgen::strategy {

/// Rounding of e is a small multiple of ε times this, which is not less than |e|: of sums, the sizes of their terms; of products, the
/// size of each factor times the others; of sines and cosines, 1 and what is added to their angles; of other functions, they
/// themselves, and their slope times the size of their argument (running error analysis: N. J. Higham, Accuracy and Stability of
/// Numerical Algorithms, section 3.3). What rounding of a coordinate does beneath a sine or cosine is not in it.
class TermSize {
 public:
  explicit TermSize(ir::Graph& graph) : graph_(graph), bounds_(graph) {}

  ir::Expr operator()(ir::Expr e);

 private:
  ir::Expr of(ir::NodeId id);
  ir::Expr of_sum(const ir::Node& node, bool with_coordinates);
  ir::Expr of_product(const ir::Node& node);
  ir::Expr of_power(ir::NodeId id);
  ir::Expr of_function(ir::NodeId id);
  ir::Expr of_angle(ir::NodeId angle);
  ir::Expr bound(ir::NodeId id);
  ir::Expr known(ir::NodeId id) const { return {graph_, *found_.find(id)}; }
  ir::Expr number(const ir::Rational& value) { return {graph_, graph_.constant(value)}; }

  ir::Graph& graph_;
  Bounds bounds_;
  ir::NodeTable<ir::NodeId> found_;
};

}  // namespace gaussgen::strategy
