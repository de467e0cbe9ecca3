#include "passes/writing.hpp"

#include "ir/traverse.hpp"

namespace gaussgen::passes {

using ir::Kind;
using ir::Node;
using support::Rational;

Writing::Writing(Graph& graph, const std::vector<NodeId>& roots) : graph_(graph) {
  for (const NodeId id : ir::post_order(graph, roots)) {
    const Node& node = graph[id];
    if (node.kind == Kind::power && node.value == -1) inverted_.insert(node.children[0].index);
  }
  walk(roots);
  ready_ = ir::ready_times(graph, roots);
}

// Not ir::post_order: the graph grows meanwhile, and powers have other operands than children.
void Writing::walk(const std::vector<NodeId>& roots) {
  std::unordered_set<std::uint32_t> finished;
  std::vector<NodeId> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const NodeId id = stack.back();
    if (reached_.insert(id.index).second) {
      decompose(id);
      const ir::Children& below = operands(id);
      for (auto it = below.rbegin(); it != below.rend(); ++it) {
        if (reached_.count(it->index) == 0) stack.push_back(*it);
      }
    } else {
      stack.pop_back();
      if (finished.insert(id.index).second) order_.push_back(id);
    }
  }
}

const ir::Children& Writing::operands(NodeId id) const {
  const Node& node = graph_[id];
  if (const auto choice = choices_.find(id.index); choice != choices_.end()) return choice->second;
  if (node.kind == Kind::power) return power_form(id).operands;
  return node.children;
}

void Writing::decompose(NodeId id) {
  const Node& node = graph_[id];
  if (node.kind == Kind::power) forms_.emplace(id.index, form_of(id));
  const bool is_choice = node.kind == Kind::function && ir::is_choice(node.function);
  if (is_choice && node.function != ir::Function::select) choices_.emplace(id.index, choice_of(id));
}

// Written as comparisons and selections, which mention what they compare at least twice.
ir::Children Writing::choice_of(NodeId id) const {
  const Node& node = graph_[id];
  ir::Children compared = node.children;
  ir::Children operands;
  if (node.function == ir::Function::piecewise) {
    operands = {node.children[1], node.children[2]};
    compared = graph_[node.children[0]].children;
  }
  for (int times = 0; times < 2; ++times) operands.insert(operands.end(), compared.begin(), compared.end());
  return operands;
}

PowerForm Writing::form_of(NodeId power) {
  const NodeId base = graph_[power].children[0];
  const Rational exponent = graph_[power].value;
  if (support::is_integer(exponent)) return integer_power(base, support::to_int(exponent));
  if (cln::denominator(exponent) != 2) return {PowerForm::Kind::general, {base}};
  const Rational half = Rational(1) / 2;
  if (exponent < 0) return {PowerForm::Kind::reciprocal, {graph_.power(base, -exponent)}};
  if (exponent == half) return {PowerForm::Kind::square_root, {base}};
  return {PowerForm::Kind::factors, {graph_.power(base, exponent - half), graph_.power(base, half)}};
}

PowerForm Writing::integer_power(NodeId base, int exponent) {
  const bool is_inverted = inverted_.count(base.index) != 0;
  if (exponent == -1) return {PowerForm::Kind::reciprocal, {base}};
  if (exponent < 0 && !is_inverted) return {PowerForm::Kind::reciprocal, {graph_.power(base, -exponent)}};
  // By squaring, which shares x^2 with every other power of x: x^3 = x x^2, x^4 = x^2 x^2, x^5 = x x^2 x^2.
  const NodeId unit = graph_.power(base, exponent < 0 ? -1 : 1);
  if (exponent == 3 || exponent == -3) return {PowerForm::Kind::factors, {unit, graph_.power(unit, 2)}};
  const NodeId half = graph_.power(base, exponent / 2);
  if (exponent % 2 == 0) return {PowerForm::Kind::factors, {half, half}};
  return {PowerForm::Kind::factors, {unit, half, half}};
}

}  // namespace gaussgen::passes
