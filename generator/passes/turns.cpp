#include <algorithm>
#include <optional>

#include "ir/traverse.hpp"
#include "passes/angles.hpp"
#include "passes/rewrite.hpp"
#include "passes/share.hpp"
#include "passes/worth.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

/// More terms than this do not come from turning by one angle.
constexpr std::size_t k_most_terms = 48;

/// Of sums in sums, as moments of forces are of angular velocities.
constexpr int k_most_depth = 3;

std::vector<NodeId> factors(const Graph& graph, NodeId term) {
  return graph[term].kind == Kind::product ? listed(graph[term].children) : std::vector<NodeId>{term};
}

/// The angle of a sine, a cosine or a power of one.
std::optional<NodeId> angle_of(const Graph& graph, NodeId factor) {
  const Node& node = graph[factor];
  if (node.kind == Kind::power) return angle_of(graph, node.children[0]);
  const bool is_circular =
      node.kind == Kind::function && (node.function == Function::sin || node.function == Function::cos);
  return is_circular ? std::optional(node.children[0]) : std::nullopt;
}

bool turns_by(const Graph& graph, NodeId term, NodeId angle) {
  for (const NodeId factor : factors(graph, term)) {
    if (angle_of(graph, factor) == angle) return true;
  }
  return false;
}

class Turner {
 public:
  Turner(Graph& graph, const Request& request)
      : graph_(graph),
        order_(ir::post_order(graph, request.outputs)),
        rewrite_(graph),
        worth_(graph, order_, request.outputs) {}

  Request run(const Request& request) {
    for (const NodeId id : order_) {
      const NodeId rebuilt = rewrite_.rebuilt(id);
      worth_.replace(id, rebuilt);
      const NodeId now = turned_back(rebuilt);
      worth_.replace(rebuilt, now);
      rewrite_.replace(id, now);
    }
    return rewrite_(request);
  }

 private:
  // Each step takes fewer operations, so this ends.
  NodeId turned_back(NodeId id) {
    bool is_shorter = true;
    while (is_shorter && graph_[id].kind == Kind::sum) {
      is_shorter = false;
      for (const NodeId angle : angles_in(id)) {
        const std::optional<NodeId> shorter = without_turns(id, angle);
        if (!shorter) continue;
        id = *shorter;
        is_shorter = true;
        break;
      }
    }
    return id;
  }

  /// By which terms are turned that have a turned sum among their factors, two of them at least.
  std::vector<NodeId> angles_in(NodeId id) const {
    std::vector<NodeId> once, twice;
    const Node& sum = graph_[id];
    for (const NodeId term : sum.children) {
      for (const NodeId factor : factors(graph_, term)) {
        const std::optional<NodeId> angle = angle_of(graph_, factor);
        if (!angle || !turned_factor(term, *angle)) continue;
        const bool is_known = std::find(once.begin(), once.end(), *angle) != once.end();
        const bool is_listed = std::find(twice.begin(), twice.end(), *angle) != twice.end();
        if (!is_known) once.push_back(*angle);
        if (is_known && !is_listed) twice.push_back(*angle);
      }
    }
    return twice;
  }

  /// The sum among the factors of a term that has been turned by the angle.
  std::optional<NodeId> turned_factor(NodeId term, NodeId angle, int depth = k_most_depth) const {
    for (const NodeId factor : factors(graph_, term)) {
      if (is_turned(factor, angle, depth)) return factor;
    }
    return std::nullopt;
  }

  bool is_turned(NodeId factor, NodeId angle, int depth) const {
    const Node& sum = graph_[unwrapped(graph_, factor)];
    if (sum.kind != Kind::sum || sum.children.size() > k_most_terms) return false;
    return std::any_of(sum.children.begin(), sum.children.end(), [&](NodeId term) {
      return turns_by(graph_, term, angle) || (depth > 1 && turned_factor(term, angle, depth - 1));
    });
  }

  /// sin² + cos² = 1 where it applies is what makes it shorter.
  std::optional<NodeId> without_turns(NodeId id, NodeId angle) {
    const Node sum = graph_[id];
    std::vector<Term> rest, turned;
    for (std::size_t i = 0; i < sum.children.size(); ++i) {
      const bool turns = turns_by(graph_, sum.children[i], angle);
      (turns ? turned : rest).push_back({sum.coefficients[i], sum.children[i]});
    }
    if (!multiply_out(turned, angle)) return std::nullopt;
    turned.insert(turned.end(), rest.begin(), rest.end());
    const NodeId result = graph_.linear(sum.value, turned);
    return worth_.of_new(result) < worth_.of(id) ? std::optional(result) : std::nullopt;
  }

  /// False where there are too many of them.
  bool multiply_out(std::vector<Term>& terms, NodeId angle) {
    for (std::size_t i = 0; i < terms.size() && terms.size() <= k_most_terms;) {
      const Term term = terms[i];
      const std::optional<NodeId> turned = turned_factor(term.node, angle);
      if (!turned) {
        ++i;
        continue;
      }
      const NodeId rest = graph_.product({term.node, graph_.power(*turned, -1)});
      const Node inner = graph_[unwrapped(graph_, *turned)];
      terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(i));
      if (inner.value != 0) terms.push_back({term.coefficient * inner.value, rest});
      for (std::size_t k = 0; k < inner.children.size(); ++k) {
        terms.push_back({term.coefficient * inner.coefficients[k], graph_.product({rest, inner.children[k]})});
      }
    }
    return terms.size() <= k_most_terms;
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  Worth worth_;
};

}  // namespace

Request turn_back(Graph& graph, const Request& request) { return Turner(graph, request).run(request); }

}  // namespace gaussgen::passes
