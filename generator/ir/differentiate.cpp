#include "ir/differentiate.hpp"

#include "ir/traverse.hpp"
#include "support/assert.hpp"

namespace gaussgen::ir {

void Directional::seed(SymbolId symbol, Expr rate) {
  seeds_.insert_or_assign(symbol.index, rate.id());
  // What was differentiated before depends on it only where it was differentiated itself.
  if (memo_.contains(graph_.use(symbol))) memo_.clear();
}

Expr Directional::operator()(Expr function) { return {graph_, derivative(function.id())}; }

NodeId Directional::derivative(NodeId root) {
  const auto is_known = [this](NodeId id) { return is_skipped(id) || memo_.contains(id); };
  if (is_known(root)) return known(root);
  for (const NodeId id : post_order(graph_, {root}, is_known)) {
    if (!is_known(id)) memo_[id] = of_node(id);
  }
  return known(root);
}

NodeId Directional::of_node(NodeId id) {
  if (graph_.is_undefined(id)) return id;  // not even 1/0, which does not vary, has a rate
  const Node& node = graph_[id];
  switch (node.kind) {
    case Kind::constant: return graph_.constant(0);
    case Kind::symbol: {
      const auto found = seeds_.find(node.symbol.index);
      return found == seeds_.end() ? graph_.constant(0) : found->second;
    }
    case Kind::sum: {
      std::vector<Term> terms;
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (!is_skipped(node.children[i])) terms.push_back({node.coefficients[i], known(node.children[i])});
      }
      return graph_.linear(0, terms);
    }
    case Kind::product: {
      std::vector<NodeId> terms;
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (is_skipped(node.children[i]) || graph_.is_zero(known(node.children[i]))) continue;
        std::vector<NodeId> factors = listed(node.children);
        factors[i] = known(node.children[i]);
        terms.push_back(graph_.product(factors));
      }
      return graph_.sum(terms);
    }
    case Kind::power: {
      const NodeId inner = known(node.children[0]);
      if (graph_.is_zero(inner)) return inner;
      return graph_.scale(node.value, graph_.product({graph_.power(node.children[0], node.value - 1), inner}));
    }
    case Kind::function: return of_function(node);
    case Kind::named: {
      const NodeId rate = known(node.children[0]);
      return suffix_.empty() ? rate : graph_.named(rate, graph_.name(node) + suffix_);
    }
  }
  return graph_.constant(0);
}

NodeId Directional::of_function(const Node& node) {
  // A condition is constant on either side of its switch; the choice itself is differentiated branch by branch.
  if (is_boolean(node.function)) return graph_.constant(0);
  const NodeId x = node.children[0];
  const auto times_inner = [&](NodeId outer) { return graph_.product({outer, known(x)}); };
  const auto one_plus = [&](int sign, NodeId a) { return graph_.linear(1, {{sign, a}}); };
  bool all_zero = true;
  for (const NodeId child : node.children) all_zero = all_zero && graph_.is_zero(known(child));
  if (all_zero) return graph_.constant(0);
  const NodeId square = graph_.power(x, 2);
  const Rational minus_half = Rational(-1) / 2;
  switch (node.function) {
    case Function::sin: return times_inner(graph_.call(Function::cos, {x}));
    case Function::cos: return graph_.scale(-1, times_inner(graph_.call(Function::sin, {x})));
    case Function::tan: return times_inner(graph_.power(graph_.call(Function::cos, {x}), -2));
    case Function::asin: return times_inner(graph_.power(one_plus(-1, square), minus_half));
    case Function::acos: return graph_.scale(-1, times_inner(graph_.power(one_plus(-1, square), minus_half)));
    case Function::atan: return times_inner(graph_.power(one_plus(1, square), -1));
    case Function::exp: return times_inner(graph_.call(Function::exp, {x}));
    case Function::log: return times_inner(graph_.power(x, -1));
    case Function::sinh: return times_inner(graph_.call(Function::cosh, {x}));
    case Function::cosh: return times_inner(graph_.call(Function::sinh, {x}));
    case Function::tanh: return times_inner(one_plus(-1, graph_.power(graph_.call(Function::tanh, {x}), 2)));
    case Function::atan2: {
      // d atan2(y, x) = (x dy - y dx) / (x² + y²)
      const NodeId y = node.children[0];
      const NodeId z = node.children[1];
      const NodeId top = graph_.linear(0, {{1, graph_.product({z, known(y)})}, {-1, graph_.product({y, known(z)})}});
      const NodeId bottom = graph_.sum({graph_.power(y, 2), graph_.power(z, 2)});
      return graph_.product({top, graph_.power(bottom, -1)});
    }
    case Function::abs: return times_inner(graph_.call(Function::sign, {x}));
    case Function::sign: return graph_.constant(0);
    // Of the one that is chosen.
    case Function::min: return chosen(graph_.call(Function::at_most, {x, node.children[1]}), node, 0);
    case Function::max: return chosen(graph_.call(Function::at_most, {node.children[1], x}), node, 0);
    case Function::piecewise:
    case Function::select: return chosen(x, node, 1);
    case Function::table: return times_inner(graph_.look_up(node.table, support::to_int(node.value) + 1, x));
    default: GAUSS_ASSERT(false, "no derivative of {}", name_of(node.function)); return x;
  }
}

NodeId Directional::chosen(NodeId condition, const Node& node, std::size_t first) {
  const Function choice = node.function == Function::select ? Function::select : Function::piecewise;
  return graph_.call(choice, {condition, known(node.children[first]), known(node.children[first + 1])});
}

Expr partial(Expr function, SymbolId symbol) {
  Directional direction(function.graph());
  direction.seed(symbol, Expr(function.graph(), function.graph().constant(1)));
  return direction(function);
}

Expr slope(Expr function, std::size_t child) {
  Graph& graph = function.graph();
  Directional along(graph);
  const Children children = graph[function.id()].children;
  for (const NodeId other : children) along.take({graph, other}, {graph, graph.constant(0)});
  along.take({graph, children[child]}, {graph, graph.constant(1)});
  return along(function);
}

}  // namespace gaussgen::ir
