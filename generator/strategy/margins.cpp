#include "strategy/margins.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

std::vector<ir::NodeId> ids_of(const std::vector<std::pair<Expr, Expr>>& required) {
  std::vector<ir::NodeId> ids;
  for (const auto& [value, bound] : required) ids.insert(ids.end(), {value.id(), bound.id()});
  return ids;
}

}  // namespace

Expr Margins::violated(const std::string& least) const {
  const std::vector<ir::NodeId> order = ir::post_order(graph_, ids_of(required_));
  const ir::NodeSet varying = ir::depends_on(graph_, order, ir::varies);
  const Expr zero(graph_, graph_.constant(0));
  std::vector<Expr> conditions;
  std::vector<Expr> prepared;
  for (const auto& [value, bound] : required_) {
    if (varying.contains(value.id()) || varying.contains(bound.id())) {
      conditions.push_back(at_most(value, bound));
    } else if (const Expr decided = at_most(value, bound); decided.is_one()) {
      return decided;
    } else if (!decided.is_zero()) {
      const Expr margin = value - bound;
      if (std::find(prepared.begin(), prepared.end(), margin) == prepared.end()) prepared.push_back(margin);
    }
  }
  if (!prepared.empty()) {
    Expr smallest = prepared[0];
    for (const Expr margin : prepared) smallest = select(less(margin, smallest), margin, smallest);
    conditions.push_back(at_most(prepared.size() > 1 ? smallest.named(least) : smallest, zero));
  }
  return any(graph_, conditions);
}

}  // namespace gaussgen::strategy
