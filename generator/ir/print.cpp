#include "ir/print.hpp"

namespace gaussgen::ir {

namespace {

enum Precedence { k_sum = 1, k_product = 2, k_power = 3, k_atom = 4 };

class Printer {
 public:
  explicit Printer(const Graph& graph) : graph_(graph) {}
  Printer(const Graph& graph, int budget) : graph_(graph), budget_(budget), is_limited_(true) {}

  std::string text(NodeId id, int outer) const {
    if (is_limited_ && --budget_ < 0) return "...";
    const Node& node = graph_[id];
    switch (node.kind) {
      case Kind::constant: return number(node.value, outer);
      case Kind::symbol: return graph_.symbol(node.symbol).name;
      case Kind::named: return graph_.name(node);
      case Kind::sum: return bracketed(sum(node), k_sum, outer);
      case Kind::product: return bracketed(product(node), k_product, outer);
      case Kind::power:
        return bracketed(text(node.children[0], k_atom) + "^" + number(node.value, k_atom), k_power, outer);
      case Kind::function: return function(node) + "(" + list(node) + ")";
    }
    return "?";
  }

 private:
  static std::string bracketed(const std::string& inner, int own, int outer) {
    return own < outer ? "(" + inner + ")" : inner;
  }

  static std::string number(const Rational& value, int outer) {
    const bool is_plain = support::is_integer(value) && value >= 0;
    return bracketed(support::to_text(value), is_plain ? k_atom : k_sum, outer);
  }

  std::string sum(const Node& node) const {
    std::string result = node.value == 0 ? "" : support::to_text(node.value);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Rational& coefficient = node.coefficients[i];
      const bool negative = coefficient < 0;
      if (result.empty()) {
        result += negative ? "-" : "";
      } else {
        result += negative ? " - " : " + ";
      }
      const Rational size = cln::abs(coefficient);
      if (size != 1) result += support::to_text(size) + "*";
      result += text(node.children[i], k_product);
    }
    return result;
  }

  std::string product(const Node& node) const {
    std::string result;
    for (const NodeId child : node.children) result += (result.empty() ? "" : "*") + text(child, k_product);
    return result;
  }

  /// A table by its name, with a prime for each derivative.
  std::string function(const Node& node) const {
    if (node.function != Function::table) return std::string(name_of(node.function));
    return graph_.table(node.table).name + std::string(static_cast<std::size_t>(support::to_int(node.value)), '\'');
  }

  std::string list(const Node& node) const {
    std::string result;
    for (const NodeId child : node.children) result += (result.empty() ? "" : ", ") + text(child, 0);
    return result;
  }

  const Graph& graph_;
  mutable int budget_ = 0;  ///< nodes that may still be printed
  bool is_limited_ = false;
};

}  // namespace

std::string print(const Graph& graph, NodeId id) { return Printer(graph).text(id, 0); }

std::string print_brief(const Graph& graph, NodeId id, int nodes) { return Printer(graph, nodes).text(id, 0); }

}  // namespace gaussgen::ir
