#include "strategy/margins.hpp"

#include <algorithm>

#include "ir/traverse.hpp"
#include "strategy/bounds.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

std::vector<ir::NodeId> ids_of(const std::vector<std::pair<Expr, Expr>>& required) {
  std::vector<ir::NodeId> ids;
  for (const auto& [value, bound] : required) ids.insert(ids.end(), {value.id(), bound.id()});
  return ids;
}

}  // namespace

Expr without_questions(Expr condition, std::vector<ir::NodeId>& looked_at) {
  ir::Graph& graph = condition.graph();
  const ir::Node node = graph[condition.id()];
  if (node.kind != ir::Kind::function) return condition;
  if (node.function == ir::Function::not_finite) {
    looked_at.insert(looked_at.end(), node.children.begin(), node.children.end());
    return {graph, graph.constant(0)};
  }
  if (node.function != ir::Function::any) return condition;
  std::vector<Expr> rest;
  for (const ir::NodeId child : node.children) rest.push_back(without_questions(Expr(graph, child), looked_at));
  return any(graph, rest);
}

Expr Margins::violated(const std::string& least) const {
  const std::vector<ir::NodeId> order = ir::post_order(graph_, ids_of(required_));
  const ir::NodeSet varying = ir::depends_on(graph_, order, ir::varies);
  std::vector<Expr> conditions;
  Prepared prepared;
  std::vector<ir::NodeId> looked_at;
  for (const auto& [value, bound] : required_) {
    if (varying.contains(value.id()) || varying.contains(bound.id())) {
      conditions.push_back(at_most(value, bound));
      if (!bound.is_zero()) continue;
      const std::optional<Expr> largest = bound_of(value);
      if (!largest) looked_at.push_back(value.id());
      if (largest && !is_number(*largest)) prepared.finite.push_back(largest->id());
    } else if (const Expr decided = at_most(value, bound); decided.is_one()) {
      return decided;
    } else if (!decided.is_zero()) {
      prepared.margins.push_back(value - bound);
      prepared.finite.push_back(value.id());
    }
  }
  if (!prepared.finite.empty()) conditions.push_back(at_most(smallest(prepared, least), number(0)));
  if (!looked_at.empty()) conditions.push_back(not_finite(looked_at));
  return any(graph_, conditions);
}

Expr Margins::number(int value) const { return {graph_, graph_.constant(value)}; }

Expr Margins::not_finite(std::vector<ir::NodeId> values) const {
  return {graph_, graph_.call(ir::Function::not_finite, std::move(values))};
}

// Of what depends on parameters alone; zero where something is infinite.
Expr Margins::smallest(Prepared prepared, const std::string& least) const {
  const auto by_id = [](auto a, auto b) { return a.index < b.index; };
  std::sort(prepared.finite.begin(), prepared.finite.end(), by_id);
  prepared.finite.erase(std::unique(prepared.finite.begin(), prepared.finite.end()), prepared.finite.end());
  std::vector<Expr> margins;
  for (const Expr margin : prepared.margins) {
    if (std::find(margins.begin(), margins.end(), margin) == margins.end()) margins.push_back(margin);
  }
  Expr result = margins.empty() ? number(1) : margins[0];
  for (const Expr margin : margins) result = select(less(margin, result), margin, result);
  result = select(not_finite(prepared.finite), number(0), result);
  return margins.size() > 1 ? result.named(least) : result;
}

}  // namespace gaussgen::strategy
