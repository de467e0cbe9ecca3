#include "passes/share.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;

namespace {

/// Operands in one expression; beyond that a reader gets lost.
constexpr int k_longest_expression = 24;

bool is_function_value(const Node& node) { return node.kind == Kind::function && node.function < Function::less; }

class Sharer {
 public:
  Sharer(const Writing& writing, const Request& request) : writing_(writing), graph_(writing.graph()) {
    collect_names(request);
    find_pairs();
    count_uses(request);
    limit_length();
  }

  Sharing result;

 private:
  void want(NodeId wanted, const std::string& name) {
    const NodeId id = unwrapped(graph_, wanted);
    (is_trivial(graph_, id) ? names_of_trivial_ : result.names).emplace(id.index, name);
  }

  // Functions and powers have a name in themselves: sin_theta, x_2.
  void suggest(NodeId wanted, const std::string& name) {
    const NodeId id = unwrapped(graph_, wanted);
    const Kind kind = graph_[id].kind;
    if (kind != Kind::sum && kind != Kind::product) return;
    const auto known = names_of_trivial_.find(id.index);
    result.suggestions.emplace(id.index, known == names_of_trivial_.end() ? name : known->second);
  }

  void collect_names(const Request& request) {
    for (const Section& section : request.sections) {
      for (const auto& [node, name] : section.nodes) want(node, name);
    }
    for (const auto& [node, name] : request.suggestions) suggest(node, name);
    for (const NodeId id : writing_.order()) {
      if (!graph_.label(id).empty()) want(id, graph_.label(id));
    }
  }

  void find_pairs() {
    std::unordered_map<std::uint32_t, NodeId> sines;
    for (const NodeId id : writing_.order()) {
      if (is_call(id, Function::sin)) sines.emplace(graph_[id].children[0].index, id);
    }
    for (const NodeId id : writing_.order()) {
      if (!is_call(id, Function::cos)) continue;
      const auto sine = sines.find(graph_[id].children[0].index);
      if (sine == sines.end()) continue;
      result.cosine_of.emplace(sine->second.index, id);
      result.sine_of.emplace(id.index, sine->second);
    }
  }

  bool is_call(NodeId id, Function function) const {
    return graph_[id].kind == Kind::function && graph_[id].function == function;
  }

  // Users come before what they use, so the number of uses of a node is final when its turn comes.
  void count_uses(const Request& request) {
    std::unordered_map<std::uint32_t, int> uses;
    for (const NodeId id : request.outputs) ++uses[id.index];
    const std::vector<NodeId>& order = writing_.order();
    for (auto it = order.rbegin(); it != order.rend(); ++it) {
      // A result of the form -x that is also used elsewhere reads better by its name.
      const bool is_result = result.suggestions.count(it->index) != 0 && uses[it->index] > 1;
      const bool trivial = is_trivial(graph_, *it) && !is_result;
      const bool wanted = result.names.count(it->index) != 0 || is_function_value(graph_[*it]);
      if (!trivial && (wanted || uses[it->index] > 1)) result.temporaries.insert(it->index);
      if (result.sine_of.count(it->index) != 0) continue;  // its argument is counted with the sine
      for (const NodeId operand : writing_.operands(*it)) uses[operand.index] += trivial ? uses[it->index] : 1;
    }
  }

  void limit_length() {
    std::unordered_map<std::uint32_t, int> length;
    for (const NodeId id : writing_.order()) {
      int total = 0;
      for (const NodeId operand : writing_.operands(id)) total += length[operand.index];
      const bool is_long = total > k_longest_expression && !is_trivial(graph_, id);
      if (is_long) result.temporaries.insert(id.index);
      length[id.index] = result.is_temporary(id) || total == 0 ? 1 : total;
    }
  }

  const Writing& writing_;
  const Graph& graph_;
  std::unordered_map<std::uint32_t, std::string> names_of_trivial_;  ///< used where a result of the form -x is defined
};

}  // namespace

bool is_trivial(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  if (node.kind == Kind::constant || node.kind == Kind::symbol || node.kind == Kind::named) return true;
  return node.kind == Kind::sum && node.value == 0 && node.children.size() == 1 && node.coefficients[0] == -1;
}

NodeId unwrapped(const Graph& graph, NodeId id) {
  while (graph[id].kind == Kind::named) id = graph[id].children[0];
  return id;
}

std::string Sharing::name(NodeId id) const {
  if (const auto it = names.find(id.index); it != names.end()) return it->second;
  const auto it = suggestions.find(id.index);
  return it == suggestions.end() ? std::string() : it->second;
}

Sharing share(const Writing& writing, const Request& request) { return Sharer(writing, request).result; }

}  // namespace gaussgen::passes
