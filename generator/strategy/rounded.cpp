#include "strategy/rounded.hpp"

#include <vector>

namespace gaussgen::strategy {

using ir::Expr;
using support::Rational;

namespace {

constexpr long k_bits = 400;

Rational rounded(const Rational& exact) {
  const cln::cl_I numerator = cln::numerator(exact);
  const cln::cl_I denominator = cln::denominator(exact);
  const long above = static_cast<long>(cln::integer_length(numerator));
  const long below = static_cast<long>(cln::integer_length(denominator));
  if (above <= k_bits && below <= k_bits) return exact;
  const long shift = k_bits - above + below;
  const Rational scale = shift < 0 ? Rational(1) / cln::expt_pos(cln::cl_I(2), cln::cl_I(-shift))
                                   : Rational(cln::expt_pos(cln::cl_I(2), cln::cl_I(shift > 0 ? shift : 1)));
  return Rational(cln::round1(exact * scale)) / scale;
}

}  // namespace

Expr rounded(Expr value) {
  ir::Graph& graph = value.graph();
  const ir::Node node = graph[value.id()];
  if (node.kind == ir::Kind::constant) return {graph, graph.constant(rounded(node.value))};
  if (node.kind != ir::Kind::sum) return value;
  Expr result(graph, graph.constant(rounded(node.value)));
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    result += rounded(node.coefficients[i]) * Expr(graph, node.children[i]);
  }
  return result;
}

}  // namespace gaussgen::strategy
