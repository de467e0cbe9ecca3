#include "ir/cost.hpp"

#include "ir/traverse.hpp"

namespace gaussgen::ir {

namespace {

int multiplications_of_power(int exponent) {
  int count = 0;
  for (int rest = exponent; rest > 1; rest /= 2) count += 1 + rest % 2;
  return count;
}

class Counter {
 public:
  Counter(const Graph& graph, const std::vector<char>& counted) : graph_(graph), counted_(counted) {}

  void add(NodeId id) {
    const Node& node = graph_[id];
    switch (node.kind) {
      case Kind::sum: add_sum(node); break;
      case Kind::product: add_product(node); break;
      case Kind::power: add_power(node); break;
      case Kind::function: add_function(node); break;
      default: break;
    }
  }

  OperationCount count;

 private:
  void add_sum(const Node& node) {
    count.additions += static_cast<int>(node.children.size()) - (node.value == 0 ? 1 : 0);
    for (const Rational& coefficient : node.coefficients) {
      if (cln::abs(coefficient) != 1) ++count.multiplications;
    }
  }

  // Reciprocal factors share one division: a b / (c d).
  void add_product(const Node& node) {
    int top = 0;
    int bottom = 0;
    for (const NodeId child : node.children) (is_reciprocal(child) ? bottom : top) += 1;
    count.multiplications += (top > 0 ? top - 1 : 0) + (bottom > 0 ? bottom - 1 : 0);
    if (bottom > 0 && top > 0) ++count.divisions;
  }

  bool is_reciprocal(NodeId id) const {
    const Node& node = graph_[id];
    return node.kind == Kind::power && node.value < 0 && counted_[id.index] != 0;
  }

  void add_power(const Node& node) {
    const Rational size = cln::abs(node.value);
    if (support::is_integer(size)) {
      count.multiplications += multiplications_of_power(support::to_int(size));
    } else if (cln::denominator(size) == 2) {
      ++count.square_roots;
      count.multiplications += multiplications_of_power(cln::cl_I_to_int(cln::numerator(size)));
    } else {
      ++count.functions;
      ++count.by_function["pow"];
    }
  }

  void add_function(const Node& node) {
    if (node.function >= Function::less) return;
    ++count.functions;
    ++count.by_function[std::string(name_of(node.function))];
  }

  const Graph& graph_;
  const std::vector<char>& counted_;
};

}  // namespace

OperationCount count_operations(const Graph& graph, const std::vector<NodeId>& roots, bool with_preparation) {
  const std::vector<NodeId> order = post_order(graph, roots);
  std::vector<char> counted = depends_on(graph, order, varies);
  if (with_preparation) std::fill(counted.begin(), counted.end(), 1);
  Counter counter(graph, counted);
  for (const NodeId id : order) {
    if (counted[id.index] != 0) counter.add(id);
  }
  return counter.count;
}

int operations(const Graph& graph, const std::vector<NodeId>& roots) { return count_operations(graph, roots).total(); }

}  // namespace gaussgen::ir
