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

std::size_t count_of_terms(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  return node.kind == Kind::sum ? node.children.size() + (node.value == 0 ? 0 : 1) : 1;
}

struct Power {
  NodeId base;
  int exponent;
};

/// A square of a sum is multiplied out as two factors.
Power as_power(const Graph& graph, NodeId factor) {
  const Node& node = graph[factor];
  const bool is_square = node.kind == Kind::power && node.value == 2 && graph[node.children[0]].kind == Kind::sum;
  return is_square ? Power{node.children[0], 2} : Power{factor, 1};
}

std::vector<NodeId> factors_of(const Graph& graph, NodeId product) {
  return graph[product].kind == Kind::product ? listed(graph[product].children) : std::vector<NodeId>{product};
}

/// How many terms `expanded` gives: 1 where they would be too many.
std::size_t expanded_count(const Graph& graph, NodeId product) {
  std::size_t count = 1;
  for (const NodeId factor : factors_of(graph, product)) {
    const auto [base, exponent] = as_power(graph, factor);
    for (int repeat = 0; repeat < exponent; ++repeat) {
      count *= count_of_terms(graph, base);
      if (count > k_expansion_limit) return 1;
    }
  }
  return count;
}

/// Counted before anything is multiplied: of long sums there is nothing to throw away.
bool has_too_many_terms(const Graph& graph, const std::vector<NodeId>& products) {
  std::size_t count = 0;
  for (const NodeId product : products) {
    const Node& node = graph[product];
    const std::vector<NodeId> terms = node.kind == Kind::sum ? listed(node.children) : std::vector<NodeId>{product};
    if (node.kind == Kind::sum && node.value != 0) ++count;
    for (const NodeId term : terms) count += expanded_count(graph, term);
    if (count > k_expansion_limit) return true;
  }
  return false;
}

/// A product whose factors include sums (or small powers of sums), as the sum of all products of their terms.
std::vector<Term> expanded(Graph& graph, const Term& product) {
  if (expanded_count(graph, product.node) == 1) return {product};
  std::vector<Term> result{{product.coefficient, graph.constant(1)}};
  for (const NodeId factor : factors_of(graph, product.node)) {
    const auto [base, exponent] = as_power(graph, factor);
    const std::vector<Term> terms = terms_of(graph, base);
    for (int repeat = 0; repeat < exponent; ++repeat) {
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
  if (has_too_many_terms(graph, products)) return {graph, plain};
  std::vector<Term> flat;
  for (const NodeId product : products) {
    for (const Term& term : terms_of(graph, product)) {
      const std::vector<Term> parts = expanded(graph, term);
      flat.insert(flat.end(), parts.begin(), parts.end());
    }
  }
  const NodeId multiplied_out = graph.linear(0, flat);
  // Mostly there is nothing to multiply out; then nobody has to count all that the products consist of.
  if (multiplied_out == plain) return {graph, plain};
  return {graph, takes_fewer_operations(graph, multiplied_out, plain) ? multiplied_out : plain};
}

Expr dot(const Vector3& a, const Vector3& b) {
  return contract(a[0].graph(), {{a[0], b[0]}, {a[1], b[1]}, {a[2], b[2]}});
}

Vector3 multiply(const Matrix3& m, const Vector3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

}  // namespace gaussgen::ir
