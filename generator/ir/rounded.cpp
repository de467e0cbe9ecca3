#include "ir/rounded.hpp"

#include <algorithm>
#include <vector>

namespace gaussgen::ir {

using support::Rational;

namespace {

constexpr long k_bits = 352;

long length(const cln::cl_I& value) { return static_cast<long>(cln::integer_length(value)); }

bool is_long(const Rational& value) {
  return length(cln::numerator(value)) > k_bits || length(cln::denominator(value)) > k_bits;
}

Rational rounded(const Rational& exact) {
  if (!is_long(exact)) return exact;
  const long above = length(cln::numerator(exact));
  const long below = length(cln::denominator(exact));
  const long shift = k_bits - above + below;
  const Rational scale = shift < 0 ? Rational(1) / cln::expt_pos(cln::cl_I(2), cln::cl_I(-shift))
                                   : Rational(cln::expt_pos(cln::cl_I(2), cln::cl_I(shift > 0 ? shift : 1)));
  return Rational(cln::round1(exact * scale)) / scale;
}

bool is_rounding(const Rational& value) {
  static const Rational k_least = cln::expt(Rational(10), -100);
  return cln::abs(value) < k_least;
}

}  // namespace

Expr rounded(Expr value) {
  Graph& graph = value.graph();
  const Node node = graph[value.id()];
  if (node.kind == Kind::constant) return {graph, graph.constant(rounded(node.value))};
  if (node.kind != Kind::sum) return value;
  const auto& coefficients = node.coefficients;
  if (!is_long(node.value) && std::none_of(coefficients.begin(), coefficients.end(), is_long)) return value;
  Expr result(graph, graph.constant(rounded(node.value)));
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    result += rounded(node.coefficients[i]) * Expr(graph, node.children[i]);
  }
  return result;
}

Expr without_rounding(Expr residual) {
  Graph& graph = residual.graph();
  const Node node = graph[residual.id()];
  const bool has_number = node.kind == Kind::constant || node.kind == Kind::sum;
  return has_number && is_rounding(node.value) ? residual - Expr(graph, graph.constant(node.value)) : residual;
}

}  // namespace gaussgen::ir
