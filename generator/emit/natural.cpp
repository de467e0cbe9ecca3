#include "emit/natural.hpp"

#include <algorithm>

namespace gaussgen::emit {

using ir::Kind;
using ir::Node;
using ir::NodeId;
using ir::Rational;

namespace {

constexpr std::size_t k_longest = 26;
constexpr std::size_t k_most_factors = 3;

class Namer {
 public:
  Namer(const ir::Graph& graph, const std::function<std::string(NodeId)>& name_of) : graph_(graph), name_of_(name_of) {}

  std::string composed(NodeId id) const {
    const Node& node = graph_[id];
    switch (node.kind) {
      case Kind::function: return of_function(node);
      case Kind::power: return of_power(node);
      case Kind::sum: return of_sum(node);
      case Kind::product: return of_product(node);
      case Kind::named: return of_named(node);
      default: return {};
    }
  }

 private:
  // A trailing underscore keeps a word from being a keyword; inside a longer name it is not needed.
  std::string operand(NodeId id) const {
    std::string name = name_of_(id);
    if (name.empty()) return composed(id);
    while (name.back() == '_') name.pop_back();
    return name;
  }

  /// t1 says nothing inside of a longer name, except as the argument of a function.
  std::string speaking(NodeId id) const {
    std::string name = operand(id);
    const bool is_numbered = name.size() > 1 && (name[0] == 't' || name[0] == 'c') &&
                             name.find_first_not_of("0123456789", 1) == std::string::npos;
    return is_numbered ? std::string() : name;
  }

  static std::string joined(const std::string& a, const std::string& between, const std::string& b) {
    return a.empty() || b.empty() ? std::string() : a + between + b;
  }

  // Its definition may have got another name, since this one was taken.
  std::string of_named(const Node& node) const {
    const std::string given = name_of_(node.children[0]);
    return given.empty() ? graph_.name(node) : given;
  }

  std::string of_function(const Node& node) const {
    if (node.function >= ir::Function::less) return {};
    std::string name = name_of_function(node);
    for (const NodeId child : node.children) name = joined(name, "_", operand(child));
    return name;
  }

  std::string name_of_function(const Node& node) const {
    if (node.function != ir::Function::table) return std::string(ir::name_of(node.function));
    const std::string derivative = node.value == 0 ? "" : "_d" + support::to_text(node.value);
    return graph_.table(node.table).name + derivative;
  }

  std::string of_power(const Node& node) const {
    const std::string base = speaking(node.children[0]);
    if (node.value == Rational(1) / 2) return joined("sqrt", "_", base);
    if (node.value < 0) return joined("inv", "_", whole_power(base, -node.value));
    return whole_power(base, node.value);
  }

  static std::string whole_power(const std::string& base, const Rational& exponent) {
    if (exponent == 1) return base;
    if (exponent > 9 || !support::is_integer(exponent)) return {};
    return joined(base, "_", support::to_text(exponent));
  }

  std::string of_sum(const Node& node) const {
    if (node.value == 0 && node.children.size() == 1) return of_multiple(node.coefficients[0], node.children[0]);
    if (node.value != 0 || node.children.size() != 2) return {};
    const Rational product = node.coefficients[0] * node.coefficients[1];
    if (cln::abs(node.coefficients[0]) != 1 || cln::abs(product) != 1) return {};
    const std::string first = speaking(node.children[0]);
    const std::string second = speaking(node.children[1]);
    if (product == 1) return joined(first, "_plus_", second);
    return node.coefficients[0] == 1 ? joined(first, "_minus_", second) : joined(second, "_minus_", first);
  }

  bool is_epsilon(NodeId id) const {
    const Node& node = graph_[id];
    return node.kind == Kind::symbol && graph_.symbol(node.symbol).symbol_class == ir::SymbolClass::epsilon;
  }

  bool is_rounding(NodeId id) const {
    const Node& node = graph_[id];
    const auto is_unit = [this](NodeId child) { return is_epsilon(child); };
    return node.kind == Kind::product && std::any_of(node.children.begin(), node.children.end(), is_unit);
  }

  std::string of_multiple(const Rational& factor, NodeId id) const {
    if (is_rounding(id)) return composed(id);
    if (factor == 2) return joined("two", "_", speaking(id));
    if (factor == Rational(1) / 2) return joined("half", "_", speaking(id));
    if (cln::numerator(factor) == 1) return joined(speaking(id), "_over_", support::to_text(cln::denominator(factor)));
    return {};
  }

  std::string of_product(const Node& node) const {
    if (node.children.size() > k_most_factors) return {};
    std::string top;
    std::string bottom;
    bool has_epsilon = false;  // then it is what rounding makes of the other factors
    for (const NodeId child : node.children) {
      if (is_epsilon(child)) {
        has_epsilon = true;
        continue;
      }
      const Node& factor = graph_[child];
      const bool is_reciprocal = factor.kind == Kind::power && factor.value < 0;
      const std::string name =
          is_reciprocal ? whole_power(speaking(factor.children[0]), -factor.value) : speaking(child);
      if (name.empty()) return {};
      std::string& place = is_reciprocal ? bottom : top;
      place += (place.empty() ? "" : "_") + name;
    }
    if (has_epsilon) top = joined("rounding", "_", top);
    if (top.empty()) return joined("inv", "_", bottom);
    return bottom.empty() ? top : joined(top, "_over_", bottom);
  }

  const ir::Graph& graph_;
  const std::function<std::string(NodeId)>& name_of_;
};

}  // namespace

std::string natural_name(const ir::Graph& graph, NodeId id, const std::function<std::string(NodeId)>& name_of) {
  const std::string name = Namer(graph, name_of).composed(id);
  return name.size() <= k_longest ? name : std::string();
}

}  // namespace gaussgen::emit
