#include "ir/cost.hpp"

#include <algorithm>

#include "ir/traverse.hpp"

namespace gaussgen::ir {

namespace {

int multiplications_of_power(int exponent) {
  int count = 0;
  for (int rest = exponent; rest > 1; rest /= 2) count += 1 + rest % 2;
  return count;
}

/// 1/x, 1/x^2, 1/sqrt(x): computed by a division. Other exponents go to `pow`, for which a sign costs nothing.
bool is_reciprocal(const Node& node) {
  return node.kind == Kind::power && node.value < 0 && cln::denominator(node.value) <= 2;
}

class Counter {
 public:
  Counter(const Graph& graph, const NodeSet& counted) : graph_(graph), counted_(counted) {}

  /// A reciprocal divides inside a product; used anywhere else it is a division of its own.
  void mark_uses(const std::vector<NodeId>& order, const std::vector<NodeId>& roots) {
    for (const NodeId root : roots) stands_alone_.insert(root);
    for (const NodeId id : order) {
      if (graph_[id].kind == Kind::product) continue;
      for (const NodeId child : graph_[id].children) stands_alone_.insert(child);
    }
  }

  void add(NodeId id) {
    const Node& node = graph_[id];
    switch (node.kind) {
      case Kind::sum: add_sum(node); break;
      case Kind::product: add_product(node); break;
      case Kind::power:
        add_power(node);
        add_lone_division(id);
        break;
      case Kind::function: add_function(node); break;
      default: break;
    }
  }

  void add_lone_division(NodeId id) {
    if (is_reciprocal(graph_[id]) && stands_alone_.contains(id)) ++count.divisions;
  }

  OperationCount count;

 private:
  // A coefficient of a reciprocal is its numerator: 2/x is one division.
  void add_sum(const Node& node) {
    count.additions += static_cast<int>(node.children.size()) - (node.value == 0 ? 1 : 0);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      if (cln::abs(node.coefficients[i]) != 1 && !has_free_numerator(node.children[i])) ++count.multiplications;
    }
  }

  // Reciprocal factors share one division: a b / (c d).
  void add_product(const Node& node) {
    int top = 0;
    int bottom = 0;
    for (const NodeId child : node.children) (divides(child) ? bottom : top) += 1;
    count.multiplications += (top > 0 ? top - 1 : 0) + (bottom > 0 ? bottom - 1 : 0);
    if (bottom > 0) ++count.divisions;
  }

  bool divides(NodeId id) const { return is_reciprocal(graph_[id]) && counted_.contains(id); }

  bool has_free_numerator(NodeId id) const {
    if (graph_[id].kind != Kind::product) return divides(id);
    for (const NodeId child : graph_[id].children) {
      if (!divides(child)) return false;
    }
    return true;
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
    if (node.function >= Function::less || is_choice(node.function)) return;
    if (node.function == Function::table) return add_table(node);
    ++count.functions;
    ++count.by_function[std::string(name_of(node.function))];
  }

  // As tables are emitted: x less the begin of its piece, then Horner's rule.
  void add_table(const Node& node) {
    const int degree = static_cast<int>(graph_.table(node.table).degree()) - support::to_int(node.value);
    count.additions += 1 + degree;
    count.multiplications += degree;
  }

  const Graph& graph_;
  const NodeSet& counted_;
  NodeSet stands_alone_;
};

}  // namespace

OperationCount count_operations(const Graph& graph, const std::vector<NodeId>& roots, bool with_preparation) {
  const std::vector<NodeId> order = post_order(graph, roots);
  NodeSet counted = depends_on(graph, order, varies);
  if (with_preparation) {
    for (const NodeId id : order) counted.insert(id);
  }
  Counter counter(graph, counted);
  counter.mark_uses(order, roots);
  for (const NodeId id : order) {
    if (counted.contains(id)) counter.add(id);
  }
  return counter.count;
}

int operations(const Graph& graph, const std::vector<NodeId>& roots) { return count_operations(graph, roots).total(); }

int operations_of(const Graph& graph, const std::vector<NodeId>& nodes) {
  NodeSet counted;
  for (const NodeId id : nodes) {
    for (const NodeId child : graph[id].children) counted.insert(child);
    counted.insert(id);
  }
  Counter counter(graph, counted);
  for (const NodeId id : nodes) counter.add(id);
  return counter.count.total();
}

namespace {

bool is_foot(const Graph& graph, NodeId id) {
  return graph[id].kind == Kind::function || graph[id].kind == Kind::named;
}

/// What lies below functions and named values: all with an index from `least` on, which is all that is asked for, since a
/// node is made after its children.
class Below {
 public:
  Below(const Graph& graph, const std::vector<NodeId>& feet, std::uint32_t least) : graph_(graph), least_(least) {
    std::vector<NodeId> stack;
    for (const NodeId foot : feet) enter(foot, stack);
    while (!stack.empty()) {
      const NodeId id = stack.back();
      stack.pop_back();
      if (contains(id)) continue;
      all_.insert(id);
      enter(id, stack);
    }
  }

  bool contains(NodeId id) const { return all_.contains(id); }
  bool has_alone(NodeId id) const { return stands_alone_.contains(id); }

 private:
  void enter(NodeId id, std::vector<NodeId>& stack) {
    const Node& node = graph_[id];
    for (const NodeId child : node.children) {
      if (child.index < least_) continue;
      if (node.kind != Kind::product) stands_alone_.insert(child);
      if (!contains(child)) stack.push_back(child);
    }
  }

  const Graph& graph_;
  std::uint32_t least_;
  NodeSet all_;
  NodeSet stands_alone_;
};

/// The sums, products and powers of one expression, down to functions and named values: its feet.
class Surface {
 public:
  Surface(const Graph& graph, NodeId root)
      : graph_(graph), root_(root), order_(post_order(graph, {root}, [&](NodeId id) { return is_foot(graph, id); })) {
    for (const NodeId id : order_) {
      if (is_foot(graph_, id)) feet_.push_back(id);
      all_.insert(id);
    }
  }

  const std::vector<NodeId>& feet() const { return feet_; }

  bool stands_on_feet_of(const Surface& other) const {
    return feet_.size() == other.feet_.size() &&
           std::all_of(feet_.begin(), feet_.end(), [&](NodeId foot) { return other.all_.contains(foot); });
  }

  /// The first node that may count here and not in `other`, if it does not lie below both.
  std::uint32_t first_apart(const Surface& other) const {
    std::uint32_t first = 0xFFFFFFFFU;
    for (const NodeId id : order_) {
      if (!other.all_.contains(id) || is_reciprocal(graph_[id])) first = std::min(first, id.index);
    }
    return first;
  }

  /// Less those for what lies below too.
  int operations_above(const Below& below) const {
    NodeSet counted;
    for (const NodeId id : order_) {
      if (is_varying(id, counted)) counted.insert(id);
    }
    Counter counter(graph_, counted);
    counter.mark_uses(order_, {root_});
    for (const NodeId id : order_) {
      if (!counted.contains(id)) continue;
      if (!below.contains(id))
        counter.add(id);
      else if (!below.has_alone(id))
        counter.add_lone_division(id);
    }
    return counter.count.total();
  }

 private:
  bool is_varying(NodeId id, const NodeSet& varying) const {
    const Node& node = graph_[id];
    if (node.kind == Kind::symbol || is_foot(graph_, id)) return !is_of_parameters(graph_, id);
    return std::any_of(node.children.begin(), node.children.end(),
                       [&](NodeId child) { return varying.contains(child); });
  }

  const Graph& graph_;
  NodeId root_;
  std::vector<NodeId> order_;
  NodeSet all_;
  std::vector<NodeId> feet_;
};

}  // namespace

bool takes_fewer_operations(const Graph& graph, NodeId a, NodeId b) {
  const Surface left(graph, a);
  const Surface right(graph, b);
  if (!left.stands_on_feet_of(right)) return operations(graph, {a}) < operations(graph, {b});
  const Below below(graph, left.feet(), std::min(left.first_apart(right), right.first_apart(left)));
  return left.operations_above(below) < right.operations_above(below);
}

}  // namespace gaussgen::ir
