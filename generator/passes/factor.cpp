#include "passes/factor.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "ir/node_table.hpp"
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
      for (const NodeId child : graph[id].children) ++uses_[child];
    }
    for (const NodeId id : request.outputs) ++uses_[id];
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
      summands.push_back({node.coefficients[i], rewrite_(node.children[i]), *uses_.find(node.children[i]) == 1});
    }
    return factored(node.value, std::move(summands));
  }

  // Sums inside of sums, until no factor saves anything; each time there are fewer summands.
  NodeId factored(const Rational& constant, std::vector<Summand> summands) {
    while (const std::optional<Saving> best = best_factor(summands)) {
      if (const std::optional<Rational> number = best_number(summands, best->multiplications)) {
        summands = with_number_outside(*number, summands);
        continue;
      }
      const Factor* const factor = &best->factor;
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
    while (const std::optional<Rational> number = best_number(summands, 0))
      summands = with_number_outside(*number, summands);
    std::vector<Term> terms;
    for (const Summand& summand : summands) terms.push_back({summand.coefficient, summand.node});
    return graph_.linear(constant, terms);
  }

  /// The number by which so many are multiplied that it saves more to multiply their sum; what divides has it as its numerator.
  std::optional<Rational> best_number(const std::vector<Summand>& summands, int at_least) const {
    std::vector<std::pair<Rational, int>> counts;
    for (const Summand& summand : summands) {
      const Rational size = cln::abs(summand.coefficient);
      if (size == 1 || is_quotient(summand.node)) continue;
      const auto known = std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == size; });
      if (known == counts.end()) {
        counts.emplace_back(size, 1);
      } else {
        ++known->second;
      }
    }
    const auto best = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (best == counts.end() || best->second - 1 <= at_least) return std::nullopt;
    return best->first;
  }

  bool is_quotient(NodeId node) const {
    const std::vector<Factor> factors = factors_of(graph_, node);
    return std::all_of(factors.begin(), factors.end(), [](const Factor& factor) { return factor.exponent < 0; });
  }

  std::vector<Summand> with_number_outside(const Rational& number, const std::vector<Summand>& summands) {
    std::vector<Summand> inside, outside;
    for (const Summand& summand : summands) {
      const bool has_number = cln::abs(summand.coefficient) == number && !is_quotient(summand.node);
      (has_number ? inside : outside).push_back(summand);
    }
    for (Summand& summand : inside) summand.coefficient = summand.coefficient / number;
    outside.push_back({number, closed(graph_, factored(0, std::move(inside))), true});
    return outside;
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

  struct Saving {
    Factor factor;
    int multiplications = 0;
  };

  /// One multiplication is saved for each product but the one that remains.
  std::optional<Saving> best_factor(const std::vector<Summand>& summands) const {
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
        const auto [found, is_new] = place.emplace(std::pair{base.index, exponent > 0}, candidates.size());
        if (is_new) candidates.push_back({{base, exponent > 0 ? 1 : -1}, 0, 0});
        Candidate& candidate = candidates[found->second];
        ++candidate.summands;
        if (!is_alone(summand.node)) ++candidate.products;
      }
    }
    const auto best = std::max_element(candidates.begin(), candidates.end(),
                                       [](const Candidate& a, const Candidate& b) { return a.products < b.products; });
    if (best == candidates.end() || best->products < 2 || best->summands < 2) return std::nullopt;
    return Saving{best->factor, best->products - 1};
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  ir::NodeTable<int> uses_;
};

}  // namespace

Request factor_out(Graph& graph, const Request& request) { return Factoring(graph, request).run(request); }

}  // namespace gaussgen::passes
