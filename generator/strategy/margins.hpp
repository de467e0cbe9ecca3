#pragma once
// When results cannot be trusted: values that must stay above a bound.

#include <string>
#include <utility>
#include <vector>

#include "ir/expr.hpp"

namespace gaussgen::strategy {

/// Takes the questions after what is infinite out of a condition, and adds what they ask about to `looked_at`.
ir::Expr without_questions(ir::Expr condition, std::vector<ir::NodeId>& looked_at);

/// Collects values that must exceed their bounds, and says with one condition whether one does not.
///
/// One that is infinite counts as one that is too small: behind a division nobody would see it. (A bound is infinite with its value.)
/// What depends on parameters alone costs one comparison per call, however much it is: `prepare` finds the least margin.
class Margins {
 public:
  explicit Margins(ir::Graph& graph) : graph_(graph) {}

  void require(ir::Expr value, ir::Expr bound) { required_.emplace_back(value, bound); }

  /// Boolean. `least` names the prepared margin, if there is one.
  ir::Expr violated(const std::string& least) const;

 private:
  /// Of parameters alone: what must be above zero, and what must be finite.
  struct Prepared {
    std::vector<ir::Expr> margins;
    std::vector<ir::NodeId> finite;
  };
  ir::Expr smallest(Prepared prepared, const std::string& least) const;
  ir::Expr not_finite(std::vector<ir::NodeId> values) const;
  ir::Expr number(int value) const;

  ir::Graph& graph_;
  std::vector<std::pair<ir::Expr, ir::Expr>> required_;
};

}  // namespace gaussgen::strategy
