#include "passes/factor.hpp"

#include <algorithm>
#include <map>
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

/// A term of a sum; what others use as well is not taken apart.
struct Summand {
  Rational coefficient;
  NodeId node;
  bool is_private = true;
};

class Factoring {
 public:
  Factoring(Graph& graph, const Request& request)
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph) {
    for (const NodeId id : order_) {
      for (const NodeId child : graph[id].children) ++uses_[child.index];
    }
    for (const NodeId id : request.outputs) ++uses_[id.index];
  }

  Request run(const Request& request) {
    for (const NodeId id : order_) {
      rewrite_.replace(id, graph_[id].kind == Kind::sum ? sum(id) : rewrite_.rebuilt(id));
    }
    return rewrite_(request);
  }

 private:
  NodeId sum(NodeId id) {
    const Node node = graph_[id];
    std::vector<Summand> summands;
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      summands.push_back({node.coefficients[i], rewrite_(node.children[i]), uses_.at(node.children[i].index) == 1});
    }
    return factored(node.value, std::move(summands));
  }

  // Sums inside of sums, until no factor saves anything; each time there are fewer summands.
  NodeId factored(const Rational& constant, std::vector<Summand> summands) {
    while (const std::optional<Factor> factor = best_factor(summands)) {
      std::vector<Summand> inside, outside;
      Rational number = 0;
      for (const Summand& summand : summands) {
        if (!can_give(summand, *factor)) {
          outside.push_back(summand);
        } else if (summand.node == power(*factor)) {
          number = number + summand.coefficient;
        } else {
          const NodeId rest = graph_.product({summand.node, graph_.power(factor->base, -factor->exponent)});
          inside.push_back({summand.coefficient, rest, true});
        }
      }
      const NodeId inner = closed(graph_, factored(number, std::move(inside)));
      outside.push_back({1, graph_.product({power(*factor), inner}), true});
      summands = std::move(outside);
    }
    std::vector<Term> terms;
    for (const Summand& summand : summands) terms.push_back({summand.coefficient, summand.node});
    return graph_.linear(constant, terms);
  }

  NodeId power(const Factor& factor) { return graph_.power(factor.base, factor.exponent); }

  bool can_give(const Summand& summand, const Factor& factor) const {
    if (!summand.is_private && !is_alone(summand.node)) return false;
    const std::vector<Factor> factors = factors_of(graph_, summand.node);
    return std::any_of(factors.begin(), factors.end(), [&](const Factor& own) {
      const bool has_same_side = (own.exponent > 0) == (factor.exponent > 0);
      return own.base == factor.base && has_same_side;
    });
  }

  bool is_alone(NodeId node) const { return graph_[node].kind != Kind::product && graph_[node].kind != Kind::power; }

  /// Multiplications that are saved: one for each product but the one that remains.
  std::optional<Factor> best_factor(const std::vector<Summand>& summands) const {
    struct Candidate {
      Factor factor;
      int products = 0;
      int summands = 0;
    };
    std::vector<Candidate> candidates;
    std::map<std::pair<std::uint32_t, bool>, std::size_t> place;
    for (const Summand& summand : summands) {
      if (!summand.is_private && !is_alone(summand.node)) continue;
      for (const auto& [base, exponent] : factors_of(graph_, summand.node)) {
        if (graph_[base].kind == Kind::sum) continue;
        const auto [found, is_new] = place.emplace(std::pair{base.index, exponent > 0}, candidates.size());
        if (is_new) candidates.push_back({{base, exponent > 0 ? 1 : -1}, 0, 0});
        Candidate& candidate = candidates[found->second];
        ++candidate.summands;
        if (!is_alone(summand.node)) ++candidate.products;
      }
    }
    const auto best = std::max_element(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.products < b.products;
    });
    if (best == candidates.end() || best->products < 2 || best->summands < 2) return std::nullopt;
    return best->factor;
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  std::unordered_map<std::uint32_t, int> uses_;
};

}  // namespace

Request factor_out(Graph& graph, const Request& request) { return Factoring(graph, request).run(request); }

}  // namespace gaussgen::passes
