#include "passes/quotients.hpp"

#include <algorithm>
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

/// Of a divisor, so many terms are looked through.
constexpr std::size_t k_longest_divisor = 6;

struct Joined {
  std::optional<std::size_t> whole;  ///< X; none: the number of the sum
  std::size_t quotient;              ///< X x/D
  Term result;                       ///< X c/D
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
      return graph_.linear(found->whole ? node.value : Rational(0), terms);
    }
    return std::nullopt;
  }

  std::optional<Joined> joined(const Node& sum, std::size_t i) {
    const std::vector<Factor> factors = factors_of(graph_, sum.children[i]);
    for (const auto& [base, exponent] : factors) {
      if (exponent >= 0 || graph_[unwrapped(graph_, base)].kind != Kind::sum) continue;
      for (const NodeId divisor : forms_of(unwrapped(graph_, base))) {
        const Node form = graph_[divisor];
        // D = κ x + c, and c shall be a number or a single term.
        if (form.children.size() + (form.value == 0 ? 0U : 1U) != 2) continue;
        for (std::size_t k = 0; k < form.children.size(); ++k) {
          if (!divides(form.children[k], factors)) continue;
          if (const auto found = joined(sum, i, base, form, k)) return found;
        }
      }
    }
    return std::nullopt;
  }

  /// A sum as it stands, and with the values in it that have names of their own written out.
  std::vector<NodeId> forms_of(NodeId sum) {
    std::vector<NodeId> forms{sum};
    while (graph_[forms.back()].kind == Kind::sum && graph_[forms.back()].children.size() <= k_longest_divisor) {
      const Node node = graph_[forms.back()];
      std::vector<Term> terms;
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        const NodeId inner = unwrapped(graph_, node.children[i]);
        terms.push_back({node.coefficients[i], graph_[inner].kind == Kind::sum ? inner : node.children[i]});
      }
      const NodeId next = graph_.linear(node.value, terms);
      if (next == forms.back()) break;
      forms.push_back(next);
    }
    if (graph_[forms.back()].kind != Kind::sum) forms.pop_back();
    return forms;
  }

  bool divides(NodeId product, const std::vector<Factor>& factors) const {
    const std::vector<Factor> wanted = factors_of(graph_, product);
    return std::all_of(wanted.begin(), wanted.end(), [&](const Factor& factor) {
      return std::any_of(factors.begin(), factors.end(), [&](const Factor& own) {
        return own.base == factor.base && factor.exponent > 0 && own.exponent >= factor.exponent;
      });
    });
  }

  // x/D = (1 - c/D)/κ
  std::optional<Joined> joined(const Node& sum, std::size_t i, NodeId D, const Node& divisor, std::size_t k) {
    const Rational kappa = divisor.coefficients[k];
    const NodeId whole = graph_.product({sum.children[i], D, graph_.power(divisor.children[k], -1)});
    const Rational wanted = -sum.coefficients[i] / kappa;
    std::vector<Term> rest;
    for (std::size_t other = 0; other < divisor.children.size(); ++other) {
      if (other != k) rest.push_back({divisor.coefficients[other], divisor.children[other]});
    }
    const NodeId c = graph_.linear(divisor.value, rest);
    const Term result{wanted, graph_.product({whole, c, graph_.power(D, -1)})};
    if (graph_.is_one(whole) && sum.value == wanted) return Joined{std::nullopt, i, result};
    for (std::size_t j = 0; j < sum.children.size(); ++j) {
      if (j != i && sum.children[j] == whole && sum.coefficients[j] == wanted) return Joined{j, i, result};
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
