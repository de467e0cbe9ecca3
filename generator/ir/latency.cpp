#include "ir/latency.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

namespace gaussgen::ir {

namespace {

constexpr int k_sum = 4, k_product = 4, k_division = 14, k_root = 18, k_function = 60;

// What is ready first goes first.
int joined(std::vector<int> ready, int each) {
  if (ready.empty()) return 0;
  std::sort(ready.begin(), ready.end());
  int at = ready[0];
  for (std::size_t i = 1; i < ready.size(); ++i) at = std::max(at, ready[i]) + each;
  return at;
}

class Clock {
 public:
  explicit Clock(const Graph& graph) : graph_(graph) {}

  int at(NodeId id) const {
    const int* const found = ready_.find(id);
    return found == nullptr ? 0 : *found;
  }

  void visit(NodeId id) {
    if (graph_.varies(id)) ready_[id] = found(graph_[id]);
  }

  NodeTable<int> take() { return std::move(ready_); }

 private:
  int found(const Node& node) const {
    switch (node.kind) {
      case Kind::sum: return joined(terms(node), k_sum);
      case Kind::product: return joined(of_children(node), k_product);
      case Kind::power: return at(node.children[0]) + of_power(node.value);
      case Kind::function: return latest(node) + (is_comparison(node.function) ? 1 : k_function);
      default: return latest(node);
    }
  }

  static int of_power(const Rational& exponent) {
    int cycles = exponent < 0 ? k_division : 0;
    if (cln::denominator(exponent) == 2) cycles += k_root;
    if (cln::denominator(exponent) > 2) return k_function;
    if (cln::abs(exponent) > 1) cycles += k_product;
    return cycles;
  }

  static bool is_comparison(Function function) {
    return function == Function::less || function == Function::at_most || function == Function::any ||
           function == Function::select || function == Function::abs;
  }

  std::vector<int> of_children(const Node& node) const {
    std::vector<int> ready;
    for (const NodeId child : node.children) ready.push_back(at(child));
    return ready;
  }

  std::vector<int> terms(const Node& node) const {
    std::vector<int> ready = of_children(node);
    for (std::size_t i = 0; i < ready.size(); ++i) {
      if (cln::abs(node.coefficients[i]) != 1) ready[i] += k_product;
    }
    if (node.value != 0) ready.push_back(0);
    return ready;
  }

  int latest(const Node& node) const {
    int cycles = 0;
    for (const NodeId child : node.children) cycles = std::max(cycles, at(child));
    return cycles;
  }

  const Graph& graph_;
  NodeTable<int> ready_;
};

}  // namespace

NodeTable<int> ready_times(const Graph& graph, const std::vector<NodeId>& roots) {
  Clock clock(graph);
  for (const NodeId id : post_order(graph, roots)) clock.visit(id);
  return clock.take();
}

int latency(const Graph& graph, const std::vector<NodeId>& roots) {
  const NodeTable<int> ready = ready_times(graph, roots);
  int cycles = 0;
  for (const NodeId root : roots) {
    const int* const at = ready.find(root);
    cycles = std::max(cycles, at == nullptr ? 0 : *at);
  }
  return cycles;
}

}  // namespace gaussgen::ir
