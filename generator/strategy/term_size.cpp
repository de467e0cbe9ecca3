#include "strategy/term_size.hpp"

#include "ir/differentiate.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Function;
using ir::Kind;
using ir::Node;
using ir::NodeId;

namespace {

bool is_coordinate(const ir::Graph& graph, NodeId id) {
  return graph[id].kind == Kind::symbol &&
         graph.symbol(graph[id].symbol).symbol_class == ir::SymbolClass::configuration;
}

Expr absolute(Expr e) { return call(Function::abs, e); }

}  // namespace

Expr TermSize::operator()(Expr e) {
  for (const NodeId id : ir::post_order(graph_, {e.id()}, [this](NodeId known) { return found_.contains(known); })) {
    const NodeId size = of(id).id();
    found_[id] = size;
  }
  return known(e.id());
}

/// Not less than its absolute value; of parameters alone where there is such a bound, since these are not computed again and again.
Expr TermSize::bound(NodeId id) { return bounds_(id).value_or(absolute({graph_, id})); }

Expr TermSize::of(NodeId id) {
  const Node node = graph_[id];
  switch (node.kind) {
    case Kind::named: return known(node.children[0]);
    case Kind::sum: return of_sum(node, true);
    case Kind::product: return of_product(node);
    case Kind::power: return of_power(id);
    case Kind::function: return of_function(id);
    default: return absolute({graph_, id});
  }
}

Expr TermSize::of_sum(const Node& node, bool with_coordinates) {
  std::vector<ir::Term> terms;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (with_coordinates || !is_coordinate(graph_, node.children[i]))
      terms.push_back({cln::abs(node.coefficients[i]), known(node.children[i]).id()});
  }
  return {graph_, graph_.linear(cln::abs(node.value), terms)};
}

Expr TermSize::of_product(const Node& node) {
  Expr size = number(1);  // of the factors so far
  Expr product = number(1);
  for (const NodeId factor : node.children) {
    const Expr own = known(factor), most = bound(factor);
    const bool are_exact = size == product && own == most;  // products round by their own size only
    size = size * most;
    product = product * most;
    if (!are_exact) size += product / most * own;
  }
  return size;
}

Expr TermSize::of_power(NodeId id) {
  const Node node = graph_[id];
  const NodeId base = node.children[0];
  const Expr size = known(base), most = bound(base);
  const Expr value = node.value > 0 ? pow(most, node.value) : absolute({graph_, id});
  if (size == most) return value;
  return value + cln::abs(node.value) * absolute(pow(Expr(graph_, base), node.value - 1)) * size;
}

/// Of the sine or cosine of it.
Expr TermSize::of_angle(NodeId angle) {
  const Node node = graph_[angle];
  if (is_coordinate(graph_, angle)) return number(1);
  if (node.kind == Kind::named) return of_angle(node.children[0]);
  return number(1) + (node.kind == Kind::sum ? of_sum(node, false) : known(angle));
}

Expr TermSize::of_function(NodeId id) {
  const Node node = graph_[id];
  const ir::Children children = node.children;
  switch (node.function) {
    case Function::sin:
    case Function::cos: return of_angle(children[0]);
    case Function::abs: return known(children[0]);
    case Function::min:
    case Function::max: return known(children[0]) + known(children[1]);
    case Function::piecewise:
    case Function::select:
      return {graph_, graph_.call(node.function, {children[0], known(children[1]).id(), known(children[2]).id()})};
    default: break;
  }
  if (is_boolean(node.function)) return number(1);
  Expr size = absolute({graph_, id});
  for (std::size_t i = 0; i < children.size(); ++i) size += absolute(ir::slope({graph_, id}, i)) * known(children[i]);
  return size;
}

}  // namespace gaussgen::strategy
