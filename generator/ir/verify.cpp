#include "ir/verify.hpp"

#include "ir/content.hpp"
#include "ir/print.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::ir {

namespace {

class Verifier {
 public:
  explicit Verifier(const Graph& graph) : graph_(graph) {}

  void check(NodeId id) {
    const Node& node = graph_[id];
    if (node.kind == Kind::sum) check_sum(id, node);
    if (node.kind == Kind::product) check_product(id, node);
    if (node.kind == Kind::power) check_power(id, node);
    if (node.kind == Kind::function) check_function(id, node);
  }

  std::vector<std::string> found;

 private:
  void report(NodeId id, const std::string& what) { found.push_back(what + ": " + print(graph_, id)); }

  void check_order(NodeId id, const Node& node) {
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      if (graph_.compare(node.children[i - 1], node.children[i]) >= 0) report(id, "children out of order");
    }
  }

  void check_sum(NodeId id, const Node& node) {
    check_order(id, node);
    if (node.coefficients.size() != node.children.size()) report(id, "coefficients do not match children");
    if (node.children.size() == 1 && node.value == 0 && node.coefficients[0] == 1) report(id, "trivial sum");
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Kind kind = graph_[node.children[i]].kind;
      if (kind == Kind::sum || kind == Kind::constant) report(id, "nested sum or constant");
      if (node.coefficients[i] == 0) report(id, "zero coefficient");
    }
  }

  void check_product(NodeId id, const Node& node) {
    check_order(id, node);
    if (node.children.size() < 2) report(id, "trivial product");
    for (const NodeId child : node.children) {
      const Node& factor = graph_[child];
      if (factor.kind == Kind::product || factor.kind == Kind::constant) report(id, "nested product or constant");
      if (factor.kind == Kind::sum && signed_content(factor) != 1) report(id, "sum with content as a factor");
    }
    // Like bases stand side by side in canonical order.
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      if (base_of(node.children[i - 1]) == base_of(node.children[i])) report(id, "like bases not merged");
    }
  }

  NodeId base_of(NodeId id) const {
    return graph_[id].kind == Kind::power && !graph_.is_undefined(id) ? graph_[id].children[0] : id;
  }

  void check_power(NodeId id, const Node& node) {
    if (node.value == 0 || node.value == 1) report(id, "trivial exponent");
    if (!support::is_integer(node.value)) return;
    const Node& base = graph_[node.children[0]];
    if (base.kind == Kind::product || base.kind == Kind::power) report(id, "whole power not distributed");
    if (base.kind == Kind::sum && signed_content(base) != 1) report(id, "whole power of a sum with content");
    if (base.kind == Kind::constant && (base.value != 0 || node.value > 0)) report(id, "whole power of a constant");
  }

  void check_function(NodeId id, const Node& node) {
    if (node.children.empty()) return;
    if (node.function == Function::piecewise && !is_comparison(graph_[node.children[0]]))
      report(id, "a choice without a comparison");
    const Node& argument = graph_[node.children[0]];
    const bool is_negative = argument.kind == Kind::constant
                                 ? argument.value < 0
                                 : argument.kind == Kind::sum && signed_content(argument) < 0;
    if (is_negative && parity(node.function) != Parity::none) report(id, "sign inside an odd or even function");
  }

  static bool is_comparison(const Node& node) {
    return node.kind == Kind::function && (node.function == Function::less || node.function == Function::at_most);
  }

  const Graph& graph_;
};

}  // namespace

std::vector<std::string> violations(const Graph& graph, const std::vector<NodeId>& roots) {
  Verifier verifier(graph);
  for (const NodeId id : post_order(graph, roots)) verifier.check(id);
  return verifier.found;
}

}  // namespace gaussgen::ir
