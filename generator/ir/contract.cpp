#include "ir/contract.hpp"

#include "ir/cost.hpp"

namespace gaussgen::ir {

namespace {

/// Above this many products of terms no attempt to multiply out is made, so that the cost stays linear.
constexpr std::size_t k_expansion_limit = 96;

std::vector<Term> terms_of(Graph& graph, NodeId id) {
  const Node& node = graph[id];
  if (node.kind != Kind::sum) return {{1, id}};
  std::vector<Term> terms;
  if (node.value != 0) terms.push_back({node.value, graph.constant(1)});
  for (std::size_t i = 0; i < node.children.size(); ++i) terms.push_back({node.coefficients[i], node.children[i]});
  return terms;
}

/// A product whose factors include sums (or small powers of sums), as the sum of all products of their terms.
std::vector<Term> expanded(Graph& graph, const Term& product) {
  std::vector<NodeId> factors{product.node};
  if (graph[product.node].kind == Kind::product) factors = graph[product.node].children;
  std::vector<Term> result{{product.coefficient, graph.constant(1)}};
  for (const NodeId factor : factors) {
    const Node& node = graph[factor];
    const bool is_square = node.kind == Kind::power && node.value == 2 && graph[node.children[0]].kind == Kind::sum;
    const std::vector<Term> terms = terms_of(graph, is_square ? node.children[0] : factor);
    for (int repeat = 0; repeat < (is_square ? 2 : 1); ++repeat) {
      if (result.size() * terms.size() > k_expansion_limit) return {product};
      std::vector<Term> next;
      for (const Term& a : result) {
        for (const Term& b : terms) next.push_back({a.coefficient * b.coefficient, graph.product({a.node, b.node})});
      }
      result = std::move(next);
    }
  }
  return result;
}

}  // namespace

Expr contract(Graph& graph, const std::vector<std::pair<Expr, Expr>>& pairs) {
  std::vector<NodeId> products;
  for (const auto& [a, b] : pairs) products.push_back((a * b).id());
  const NodeId plain = graph.sum(products);
  std::vector<Term> flat;
  for (const NodeId product : products) {
    for (const Term& term : terms_of(graph, product)) {
      const std::vector<Term> parts = expanded(graph, term);
      flat.insert(flat.end(), parts.begin(), parts.end());
    }
    if (flat.size() > k_expansion_limit) return {graph, plain};
  }
  const NodeId multiplied_out = graph.linear(0, flat);
  // Mostly there is nothing to multiply out; then nobody has to count all that the products consist of.
  if (multiplied_out == plain) return {graph, plain};
  return {graph, operations(graph, {multiplied_out}) < operations(graph, {plain}) ? multiplied_out : plain};
}

Expr dot(const Vector3& a, const Vector3& b) {
  return contract(a[0].graph(), {{a[0], b[0]}, {a[1], b[1]}, {a[2], b[2]}});
}

Vector3 multiply(const Matrix3& m, const Vector3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

}  // namespace gaussgen::ir
