#include "passes/angles.hpp"

#include <algorithm>
#include <optional>

#include "ir/node_table.hpp"
#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

bool is_circular(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  return node.kind == Kind::function && (node.function == Function::sin || node.function == Function::cos);
}

std::vector<NodeId> circular_factors(const Graph& graph, NodeId term) {
  std::vector<NodeId> found;
  if (graph[term].kind != Kind::product) return found;
  for (const NodeId child : graph[term].children) {
    if (is_circular(graph, child)) found.push_back(child);
  }
  return found;
}

/// Two terms of a sum, and what they are together.
struct Joined {
  std::size_t first;
  std::size_t second;
  Term together;
};

class AngleJoiner {
 public:
  AngleJoiner(Graph& graph, const Request& request)
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph) {
    for (const NodeId id : order_) {
      if (is_circular(graph, id)) there_.insert(id);
    }
  }

  Request run(const Request& request) {
    for (const NodeId id : order_) rewrite_.replace(id, joined(rewrite_.rebuilt(id)));
    return rewrite_(request);
  }

 private:
  // Each time there is one term less.
  NodeId joined(NodeId id) {
    while (const std::optional<Joined> found = pair_in(id)) {
      const Node sum = graph_[id];
      std::vector<Term> terms{found->together};
      for (std::size_t i = 0; i < sum.children.size(); ++i) {
        if (i != found->first && i != found->second) terms.push_back({sum.coefficients[i], sum.children[i]});
      }
      id = graph_.linear(sum.value, terms);
    }
    return id;
  }

  std::optional<Joined> pair_in(NodeId id) {
    if (graph_[id].kind != Kind::sum) return std::nullopt;
    const Node sum = graph_[id];
    std::unordered_map<std::uint32_t, std::size_t> place;
    for (std::size_t i = 0; i < sum.children.size(); ++i) {
      if (circular_factors(graph_, sum.children[i]).size() >= 2) place.emplace(sum.children[i].index, i);
    }
    if (place.size() < 2) return std::nullopt;
    for (std::size_t i = 0; i < sum.children.size(); ++i) {
      const std::vector<NodeId> circular = circular_factors(graph_, sum.children[i]);
      for (std::size_t a = 0; a < circular.size(); ++a) {
        for (std::size_t b = a + 1; b < circular.size(); ++b) {
          const auto partner = partner_of(sum.children[i], circular[a], circular[b]);
          const auto found = partner ? place.find(partner->index) : place.end();
          if (found == place.end() || found->second == i) continue;
          if (const auto pair = together(sum, i, found->second, circular[a], circular[b])) return pair;
        }
      }
    }
    return std::nullopt;
  }

  /// The same term with the other function of both angles, if the program has those.
  std::optional<NodeId> partner_of(NodeId term, NodeId fa, NodeId fb) {
    const NodeId ga = other(fa), gb = other(fb);
    if (!there_.contains(ga) || !there_.contains(gb)) return std::nullopt;
    return graph_.product({term, graph_.power(fa, -1), graph_.power(fb, -1), ga, gb});
  }

  NodeId other(NodeId f) {
    const Node node = graph_[f];
    return graph_.call(node.function == Function::sin ? Function::cos : Function::sin, listed(node.children));
  }

  /// sin a cos b ± cos a sin b = sin(a ± b), cos a cos b ∓ sin a sin b = cos(a ± b)
  std::optional<Joined> together(const Node& sum, std::size_t i, std::size_t j, NodeId fa, NodeId fb) {
    const Rational kappa = sum.coefficients[i];
    const bool is_plus = sum.coefficients[j] == kappa;
    if (!is_plus && sum.coefficients[j] != -kappa) return std::nullopt;
    const Node left = graph_[fa], right = graph_[fb];
    const bool is_mixed = left.function != right.function;
    const bool leads_with_sine = left.function == Function::sin;
    const Rational sign_of_b = is_mixed == is_plus ? 1 : -1;
    const NodeId angle = graph_.linear(0, {{1, left.children[0]}, {sign_of_b, right.children[0]}});
    NodeId value = graph_.call(is_mixed ? Function::sin : Function::cos, {angle});
    // cos a sin b - sin a cos b = -sin(a - b), sin a sin b - cos a cos b = -cos(a + b)
    const bool is_negative = !is_plus && (is_mixed ? !leads_with_sine : leads_with_sine);
    if (!is_there(value)) return std::nullopt;
    const NodeId rest = graph_.product({sum.children[i], graph_.power(fa, -1), graph_.power(fb, -1)});
    return Joined{i, j, {is_negative ? Rational(-kappa) : kappa, graph_.product({rest, value})}};
  }

  bool is_there(NodeId value) const {
    const Node& node = graph_[value];
    const bool is_negated = node.kind == Kind::sum && node.value == 0 && node.children.size() == 1;
    return node.kind == Kind::constant || there_.contains(is_negated ? node.children[0] : value);
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  ir::NodeSet there_;
};

}  // namespace

Request join_angles(Graph& graph, const Request& request) { return AngleJoiner(graph, request).run(request); }

}  // namespace gaussgen::passes
