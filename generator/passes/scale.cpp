#include "passes/scale.hpp"

#include <algorithm>
#include <map>

#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"

namespace gaussgen::passes {

using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

/// A value as a number times a node.
struct Scaled {
  Rational factor = 1;
  NodeId node;
};

/// Numbers of many digits are no better in one place than in the other, and grow with every step.
constexpr long k_most_bits = 256;

long bits_of(const Rational& value) {
  return static_cast<long>(cln::integer_length(cln::numerator(value)) + cln::integer_length(cln::denominator(value)));
}

class UnitChoice {
 public:
  UnitChoice(Graph& graph, const Request& request) : graph_(graph), rewrite_(graph) {
    for (const NodeId id : ir::post_order(graph, request.outputs)) {
      scaled_.emplace(id.index, scaled(id));
      rewrite_.replace(id, whole(scaled_.at(id.index)));
    }
  }

  Request run(const Request& request) { return rewrite_(request); }

 private:
  const Scaled& at(NodeId id) const { return scaled_.at(id.index); }

  NodeId whole(const Scaled& value) { return graph_.scale(value.factor, value.node); }

  Scaled scaled(NodeId id) {
    const Node& node = graph_[id];
    switch (node.kind) {
      case Kind::sum: return of_sum(id);
      case Kind::product: return of_product(id);
      case Kind::power: return of_power(id);
      case Kind::named: return of_named(id);
      case Kind::function:
        if (node.function == ir::Function::less || node.function == ir::Function::at_most) return {1, compared(id)};
        [[fallthrough]];
      default: return {1, rewrite_.rebuilt(id)};
    }
  }

  // a x < b y is x < (b/a) y for a positive a.
  NodeId compared(NodeId id) {
    const Node node = graph_[id];
    const Scaled left = at(node.children[0]);
    const Scaled right = at(node.children[1]);
    const bool swaps = left.factor < 0;
    const NodeId first = left.node;
    const NodeId second = graph_.scale(right.factor / left.factor, right.node);
    return graph_.call_again(node, swaps ? std::vector<NodeId>{second, first} : std::vector<NodeId>{first, second});
  }

  Scaled apart(NodeId id) {
    const Node& node = graph_[id];
    const bool is_multiple = node.kind == Kind::sum && node.value == 0 && node.children.size() == 1;
    return is_multiple ? Scaled{node.coefficients[0], node.children[0]} : Scaled{1, id};
  }

  Scaled of_product(NodeId id) {
    Rational factor = 1;
    std::vector<NodeId> factors;
    for (const NodeId child : graph_[id].children) {
      factor = factor * at(child).factor;
      factors.push_back(at(child).node);
    }
    Scaled result = apart(graph_.product(factors));
    result.factor = result.factor * factor;
    return result;
  }

  Scaled of_power(NodeId id) {
    const Node& node = graph_[id];
    const Scaled base = at(node.children[0]);
    const Rational exponent = node.value;
    if (!support::is_integer(exponent)) return {1, graph_.power(whole(base), exponent)};
    const int n = support::to_int(exponent);
    const Rational size = cln::expt_pos(base.factor, cln::cl_I(std::abs(n)));
    return {n < 0 ? Rational(1 / size) : size, graph_.power(base.node, exponent)};
  }

  Scaled of_sum(NodeId id) {
    const Node node = graph_[id];
    std::vector<Term> terms;
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      terms.push_back({node.coefficients[i] * at(node.children[i]).factor, at(node.children[i]).node});
    }
    const NodeId now = graph_.linear(node.value, terms);
    if (graph_[now].kind != Kind::sum) return {1, now};
    const Node& sum = graph_[now];
    if (sum.value == 0 && sum.children.size() == 1) return {sum.coefficients[0], sum.children[0]};
    const Rational unit = sum.coefficients[0] < 0 ? Rational(-best_unit(sum)) : best_unit(sum);
    if (bits_of(unit) > k_most_bits) return {1, now};
    return {unit, graph_.scale(1 / unit, now)};
  }

  /// The coefficient that most terms have; of equals, the one with the shortest digits, and 1 before all.
  static Rational best_unit(const Node& sum) {
    std::map<Rational, int, bool (*)(const Rational&, const Rational&)> counts(
        [](const Rational& a, const Rational& b) { return a < b; });
    for (const Rational& c : sum.coefficients) ++counts[cln::abs(c)];
    Rational best = 1;
    int most = counts.count(Rational(1)) != 0 ? counts[Rational(1)] : 0;
    for (const auto& [size, count] : counts) {
      const bool is_shorter = best != 1 && count == most && bits_of(size) < bits_of(best);
      if (count > most || is_shorter) {
        best = size;
        most = count;
      }
    }
    return best;
  }

  Scaled of_named(NodeId id) {
    const Node node = graph_[id];
    const Scaled inner = at(node.children[0]);
    if (inner.factor == 1) return {1, graph_.kept_whole(inner.node, node.name)};
    const std::string name = node.name.empty() || cln::abs(inner.factor) == 1 ? node.name : node.name + "_scaled";
    return {inner.factor, graph_.kept_whole(inner.node, name)};
  }

  Graph& graph_;
  Rewrite rewrite_;
  std::unordered_map<std::uint32_t, Scaled> scaled_;
};

}  // namespace

Request choose_units(Graph& graph, const Request& request) { return UnitChoice(graph, request).run(request); }

}  // namespace gaussgen::passes
