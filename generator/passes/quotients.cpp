#include "passes/quotients.hpp"

#include <optional>

#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"
#include "passes/share.hpp"

namespace gaussgen::passes {

using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

struct Joined {
  std::size_t whole;     ///< X
  std::size_t quotient;  ///< X x/D
  Term result;           ///< X c/D
};

class Joiner {
 public:
  explicit Joiner(Graph& graph) : graph_(graph) {}

  NodeId operator()(NodeId sum) {
    NodeId result = sum;
    while (graph_[result].kind == Kind::sum) {
      const std::optional<NodeId> next = joined_once(result);
      if (!next) break;
      result = *next;
    }
    return result;
  }

 private:
  std::optional<NodeId> joined_once(NodeId sum) {
    const Node node = graph_[sum];
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const std::optional<Joined> found = joined(node, i);
      if (!found) continue;
      std::vector<Term> terms{found->result};
      for (std::size_t j = 0; j < node.children.size(); ++j) {
        if (j != found->whole && j != found->quotient) terms.push_back({node.coefficients[j], node.children[j]});
      }
      return graph_.linear(node.value, terms);
    }
    return std::nullopt;
  }

  std::optional<Joined> joined(const Node& sum, std::size_t i) {
    for (const auto& [base, exponent] : factors_of(graph_, sum.children[i])) {
      const Node& divisor = graph_[unwrapped(graph_, base)];
      if (exponent >= 0 || divisor.kind != Kind::sum) continue;
      for (std::size_t k = 0; k < divisor.children.size(); ++k) {
        // D = κ x + c, and c shall be a number or a single term.
        const bool is_short = divisor.children.size() + (divisor.value == 0 ? 0U : 1U) == 2;
        if (!is_short || !has_factor(sum.children[i], divisor.children[k])) continue;
        if (const auto found = joined(sum, i, base, divisor, k)) return found;
      }
    }
    return std::nullopt;
  }

  bool has_factor(NodeId product, NodeId factor) const {
    for (const auto& [base, exponent] : factors_of(graph_, product)) {
      if (base == factor && exponent > 0) return true;
    }
    return false;
  }

  // x/D = (1 - c/D)/κ
  std::optional<Joined> joined(const Node& sum, std::size_t i, NodeId D, const Node& divisor, std::size_t k) {
    const Rational kappa = divisor.coefficients[k];
    const NodeId x = divisor.children[k];
    const NodeId whole = graph_.product({sum.children[i], D, graph_.power(x, -1)});
    const Rational wanted = -sum.coefficients[i] / kappa;
    for (std::size_t j = 0; j < sum.children.size(); ++j) {
      if (j == i || sum.children[j] != whole || sum.coefficients[j] != wanted) continue;
      std::vector<Term> rest;
      for (std::size_t other = 0; other < divisor.children.size(); ++other) {
        if (other != k) rest.push_back({divisor.coefficients[other], divisor.children[other]});
      }
      const NodeId c = graph_.linear(divisor.value, rest);
      return Joined{j, i, {wanted, graph_.product({whole, c, graph_.power(D, -1)})}};
    }
    return std::nullopt;
  }

  Graph& graph_;
};

}  // namespace

Request join_quotients(Graph& graph, const Request& request) {
  Rewrite rewrite(graph);
  Joiner joiner(graph);
  for (const NodeId id : ir::post_order(graph, request.outputs)) {
    const NodeId now = rewrite.rebuilt(id);
    rewrite.replace(id, graph[now].kind == Kind::sum ? joiner(now) : now);
  }
  return rewrite(request);
}

}  // namespace gaussgen::passes
