#include "passes/scale.hpp"

#include <algorithm>

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

/// A value in a unit beyond this leaves the range of float, as the terms of a series do one after the other.
const Rational k_largest_unit = cln::expt_pos(cln::cl_I(2), 100);

long bits_of(const Rational& value) {
  return static_cast<long>(cln::integer_length(cln::numerator(value)) + cln::integer_length(cln::denominator(value)));
}

class UnitChoice {
 public:
  UnitChoice(Graph& graph, const Request& request) : graph_(graph), rewrite_(graph) {
    find_last(request.outputs);
    for (const NodeId id : ir::post_order(graph, request.outputs)) {
      scaled_.emplace(id.index, scaled(id));
      rewrite_.replace(id, whole(scaled_.at(id.index)));
    }
  }

  Request run(const Request& request) { return rewrite_(request); }

 private:
  /// What becomes a result by products alone: a number taken out of it would be one more factor there, and two more roundings at
  /// the end, where nothing makes them small; but for a power of two.
  void find_last(const std::vector<NodeId>& outputs) {
    std::vector<NodeId> stack = outputs;
    while (!stack.empty()) {
      const NodeId id = stack.back();
      stack.pop_back();
      if (last_.contains(id)) continue;
      last_.insert(id);
      const Node& node = graph_[id];
      const bool is_multiple = node.kind == Kind::sum && node.value == 0 && node.children.size() == 1;
      const bool passes_on = node.kind == Kind::product || node.kind == Kind::power || node.kind == Kind::named;
      if (is_multiple || passes_on) stack.insert(stack.end(), node.children.begin(), node.children.end());
    }
  }

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
        if (node.function == ir::Function::not_finite) return {1, looked_at(id)};
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

  // What no result comes from by products alone is infinite in any unit.
  NodeId looked_at(NodeId id) {
    const Node node = graph_[id];
    std::vector<NodeId> values;
    for (const NodeId value : node.children)
      values.push_back(last_.contains(value) ? whole(at(value)) : at(value).node);
    return graph_.call_again(node, values);
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
    const Rational size = best_unit(sum, last_.contains(id));
    const Rational unit = sum.coefficients[0] < 0 ? Rational(-size) : size;
    if (bits_of(unit) > k_most_bits || cln::abs(unit) < 1 / k_largest_unit || cln::abs(unit) > k_largest_unit)
      return {1, now};
    return {unit, graph_.scale(1 / unit, now)};
  }

  struct Candidate {
    Rational size;
    int count = 0;
  };

  /// The coefficient that most terms have; of equals, 1 before all, and then the one with the shortest digits.
  static Rational best_unit(const Node& sum, bool is_last) {
    std::vector<Candidate> candidates{{1, 0}};
    for (const Rational& c : sum.coefficients) {
      const Rational size = cln::abs(c);
      const auto is_same = [&](const Candidate& other) { return other.size == size; };
      const auto known = std::find_if(candidates.begin(), candidates.end(), is_same);
      if (known == candidates.end()) {
        candidates.push_back({size, 1});
      } else {
        ++known->count;
      }
    }
    std::stable_sort(candidates.begin() + 1, candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return bits_of(a.size) < bits_of(b.size); });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.count > b.count; });
    const auto best = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& unit) {
      return keeps_exact(sum, unit.size) && (!is_last || is_power_of_two(unit.size));
    });
    return best->size;  // 1, if no other
  }

  /// What is a binary fraction stays one: 3/2 - 9/4 x is no more 2/3 - x, whose number is rounded, and where the two nearly cancel,
  /// nothing but that is left.
  static bool keeps_exact(const Node& sum, const Rational& unit) {
    const auto is_kept = [&](const Rational& c) { return !is_binary(c) || is_binary(c / unit); };
    return is_kept(sum.value) && std::all_of(sum.coefficients.begin(), sum.coefficients.end(), is_kept);
  }

  static bool is_power_of_two(const Rational& value) { return is_binary(value) && is_binary(1 / value); }

  Scaled of_named(NodeId id) {
    const Node node = graph_[id];
    const Scaled inner = at(node.children[0]);
    if (inner.factor == 1) return {1, graph_.kept_whole(inner.node, graph_.name(node))};
    const std::string& own = graph_.name(node);
    const std::string name = own.empty() || cln::abs(inner.factor) == 1 ? own : own + "_scaled";
    return {inner.factor, graph_.kept_whole(inner.node, name)};
  }

  Graph& graph_;
  Rewrite rewrite_;
  ir::NodeSet last_;
  std::unordered_map<std::uint32_t, Scaled> scaled_;
};

}  // namespace

Request choose_units(Graph& graph, const Request& request) { return UnitChoice(graph, request).run(request); }

}  // namespace gaussgen::passes
