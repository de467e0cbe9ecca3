#include "strategy/safety.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

namespace gaussgen::strategy {

using ir::Expr;

Safety safety(Expr pivot) {
  const ir::Graph& graph = pivot.graph();
  const ir::Node& node = graph[pivot.id()];
  if (pivot.is_zero()) return Safety::unknown;
  if (node.kind == ir::Kind::constant) return Safety::number;
  if (!ir::is_of_parameters(graph, pivot.id())) return Safety::unknown;
  const std::vector<ir::NodeId> order = ir::post_order(graph, {pivot.id()});
  const bool has_sum = std::any_of(order.begin(), order.end(), [&](ir::NodeId id) {
    return graph[id].kind == ir::Kind::sum && (graph[id].children.size() > 1 || graph[id].value != 0);
  });
  // A difference of parameters can vanish, or keep nothing but rounding; a product only with one of its factors, and
  // then status says so.
  return has_sum ? Safety::unknown : Safety::parameter_monomial;
}

}  // namespace gaussgen::strategy
