// Our own printer over the graph: its text depends on the canonical order alone.

#include "lower/latex.hpp"

#include <algorithm>

#include "lower/latex_name.hpp"

namespace gaussgen::lower {

using ir::Kind;
using ir::Node;
using ir::NodeId;
using support::Rational;

namespace {

enum Precedence { k_sum = 1, k_product = 2, k_power = 3, k_atom = 4 };

class LatexPrinter {
 public:
  LatexPrinter(const ir::Graph& graph, const std::function<std::string(ir::SymbolId)>& name,
               const DecimalStyle& decimals)
      : graph_(graph), name_(name), decimals_(decimals) {}

  std::string text(NodeId id, int outer) const {
    const Node& node = graph_[id];
    switch (node.kind) {
      case Kind::constant: return bracketed(styled(node.value), node.value < 0 ? k_sum : k_atom, outer);
      case Kind::symbol: return symbol(node, outer);
      case Kind::named: return latex_name(graph_.name(node));
      case Kind::sum: return sum(node, outer);
      case Kind::product: return bracketed(scaled(1, id), k_product, outer);
      case Kind::power: return power(node, id, outer);
      case Kind::function: return function(node, "", outer);
    }
    return "?";
  }

  /// Terms of a sum over a number, each after the first with its sign in front.
  std::vector<std::string> terms(const Node& node, const Rational& divisor = 1) const {
    std::vector<std::string> result;
    if (node.value != 0) result.push_back(styled(node.value / divisor));
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const bool is_negative = node.coefficients[i] < 0;
      const char* sign = result.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
      result.push_back(sign + scaled(cln::abs(node.coefficients[i] / divisor), node.children[i]));
    }
    return result;
  }

 private:
  /// A factor of a product; the sum in it is over a number.
  struct Factor {
    NodeId id;
    Rational divisor = 1;
  };

  static std::string bracketed(const std::string& inner, int own, int outer) {
    return own < outer ? "\\left(" + inner + "\\right)" : inner;
  }

  static std::string joined(const std::vector<std::string>& terms) {
    std::string result;
    for (const std::string& term : terms) result += term;
    return result;
  }

  static std::string fraction(const std::string& top, const std::string& bottom) {
    return bottom.empty() ? top : "\\frac{" + top + "}{" + bottom + "}";
  }

  static std::string number(const Rational& value) {
    const std::string size = fraction(support::to_text(cln::numerator(cln::abs(value))),
                                      support::is_integer(value) ? "" : support::to_text(cln::denominator(value)));
    return (value < 0 ? "-" : "") + size;
  }

  std::string styled(const Rational& value) const { return decimals_(value).value_or(number(value)); }

  /// A name with an accent or an index of its own is bracketed before it gets an exponent.
  std::string symbol(const Node& node, int outer) const {
    const std::string name = name_(node.symbol);
    const bool is_plain = name.find('^') == std::string::npos;
    return bracketed(name, is_plain ? k_atom : k_power, outer);
  }

  std::string sum(const Node& node, int outer) const {
    const bool is_monomial = node.value == 0 && node.children.size() == 1;
    const std::string result = joined(terms(node));
    const bool is_negative = is_monomial && node.coefficients[0] < 0;
    return bracketed(result, is_monomial && !is_negative ? k_product : k_sum, outer);
  }

  /// coefficient * node with negative powers below a fraction line; coefficient > 0.
  std::string scaled(const Rational& coefficient, NodeId id) const {
    const Node& node = graph_[id];
    std::vector<Factor> above;
    std::vector<Factor> below;
    Rational rest = coefficient;
    for (const NodeId factor : node.kind == Kind::product ? listed(node.children) : std::vector<NodeId>{id}) {
      const bool is_divisor = graph_[factor].kind == Kind::power && graph_[factor].value < 0;
      (is_divisor ? below : above).push_back(is_divisor ? Factor{factor} : shifted(factor, rest));
    }
    const bool is_decimal = decimals_(rest).has_value();
    const Rational top = is_decimal ? rest : Rational(cln::numerator(rest));
    const Rational bottom = is_decimal ? Rational(1) : Rational(cln::denominator(rest));
    const bool is_fraction = !below.empty() || bottom != 1;
    return fraction(product(top, above, is_fraction, false), is_fraction ? product(bottom, below, true, true) : "");
  }

  /// (981 + 100 a)^2/20000 is (9.81 + a)^2/2: the graph keeps sums whole, with what is common to them outside.
  Factor shifted(NodeId id, Rational& coefficient) const {
    Factor factor{id};
    const Node& node = graph_[id];
    const Rational exponent = node.kind == Kind::power ? node.value : Rational(1);
    const Node& sum = node.kind == Kind::power ? graph_[node.children[0]] : node;
    if (!decimals_.is_used() || sum.kind != Kind::sum || !support::is_integer(exponent)) return factor;
    const Rational shift = cln::expt_pos(Rational(10), cln::numerator(exponent));
    const auto ends_with_zero = [&](const Rational& value) {
      return value != 0 && support::is_integer(value / factor.divisor / 10);
    };
    while (
        support::is_integer(cln::denominator(coefficient) / shift) &&
        (ends_with_zero(sum.value) || std::any_of(sum.coefficients.begin(), sum.coefficients.end(), ends_with_zero))) {
      factor.divisor = factor.divisor * 10;
      coefficient = coefficient * shift;
    }
    return factor;
  }

  std::string text(const Factor& factor, int outer) const {
    const Node& node = graph_[factor.id];
    if (factor.divisor == 1) return text(factor.id, outer);
    if (node.kind == Kind::sum) return bracketed(joined(terms(node, factor.divisor)), k_sum, outer);
    const Node& base = graph_[node.children[0]];
    return bracketed(joined(terms(base, factor.divisor)), k_sum, k_atom) + "^{" + number(node.value) + "}";
  }

  std::string product(const Rational& coefficient, const std::vector<Factor>& factors, bool in_fraction,
                      bool is_inverted) const {
    std::string result = coefficient == 1 && !factors.empty() ? "" : styled(coefficient);
    // A lone sum fills its place above or below the line without brackets.
    const bool is_alone = in_fraction && result.empty() && factors.size() == 1;
    for (const Factor& factor : factors) {
      result += result.empty() ? "" : "\\,";
      result += is_inverted ? reciprocal(factor.id, is_alone) : text(factor, is_alone ? 0 : k_product);
    }
    return result;
  }

  std::string reciprocal(NodeId id, bool is_alone) const {
    const Node& node = graph_[id];
    if (node.value == -1) return text(node.children[0], is_alone ? 0 : k_product);
    return raised(node.children[0], -node.value);
  }

  std::string raised(NodeId base, const Rational& exponent) const {
    if (exponent == 1) return text(base, k_product);
    if (exponent == Rational(1) / 2) return "\\sqrt{" + text(base, 0) + "}";
    const Node& node = graph_[base];
    const std::string superscript = "^{" + number(exponent) + "}";
    if (node.kind == Kind::function && node.function != ir::Function::exp) return function(node, superscript, k_atom);
    return text(base, k_atom) + superscript;
  }

  std::string power(const Node& node, NodeId id, int outer) const {
    if (node.value < 0) return bracketed(scaled(1, id), k_product, outer);
    return bracketed(raised(node.children[0], node.value), k_power, outer);
  }

  std::string function(const Node& node, const std::string& superscript, int outer) const {
    if (node.function == ir::Function::abs) return "\\left|" + text(node.children[0], 0) + "\\right|" + superscript;
    if (node.function == ir::Function::less) return comparison(node, " < ");
    if (node.function == ir::Function::at_most) return comparison(node, " \\le ");
    if (node.function == ir::Function::piecewise) return bracketed(cases(node), k_sum, outer) + superscript;
    return call(node, superscript);
  }

  std::string comparison(const Node& node, const std::string& sign) const {
    return text(node.children[0], k_sum) + sign + text(node.children[1], k_sum);
  }

  std::string cases(const Node& piecewise) const {
    std::string rows;
    const Node* node = &piecewise;
    for (;; node = &graph_[node->children[2]]) {
      rows += text(node->children[1], 0) + " & " + text(node->children[0], 0) + " \\\\ ";
      const Node& rest = graph_[node->children[2]];
      if (rest.kind != Kind::function || rest.function != ir::Function::piecewise) break;
    }
    return "\\begin{cases} " + rows + text(node->children[2], 0) + " & \\text{else} \\end{cases}";
  }

  std::string call(const Node& node, const std::string& superscript) const {
    std::string arguments;
    for (const NodeId child : node.children) arguments += (arguments.empty() ? "" : ", ") + text(child, 0);
    const bool is_bare = node.children.size() == 1 && graph_[node.children[0]].kind == Kind::symbol;
    return name_of_function(node) + superscript +
           (is_bare ? "{" + arguments + "}" : "\\left(" + arguments + "\\right)");
  }

  /// A table by its name, with a prime for each derivative.
  std::string name_of_function(const Node& node) const {
    if (node.function != ir::Function::table) return function_name(node.function);
    const std::string primes(static_cast<std::size_t>(support::to_int(node.value)), '\'');
    return "\\operatorname{" + latex_text(graph_.table(node.table).name) + "}" + primes;
  }

  static std::string function_name(ir::Function function) {
    switch (function) {
      case ir::Function::asin: return "\\arcsin";
      case ir::Function::acos: return "\\arccos";
      case ir::Function::atan: return "\\arctan";
      case ir::Function::log: return "\\ln";
      case ir::Function::sign: return "\\operatorname{sgn}";
      case ir::Function::min:
      case ir::Function::max:
      case ir::Function::sin:
      case ir::Function::cos:
      case ir::Function::tan:
      case ir::Function::exp:
      case ir::Function::sinh:
      case ir::Function::cosh:
      case ir::Function::tanh: return "\\" + std::string(name_of(function));
      default: return "\\operatorname{" + std::string(name_of(function)) + "}";
    }
  }

  const ir::Graph& graph_;
  const std::function<std::string(ir::SymbolId)>& name_;
  const DecimalStyle& decimals_;
};

}  // namespace

std::string latex(const ir::Graph& graph, NodeId id, const std::function<std::string(ir::SymbolId)>& name,
                  const DecimalStyle& decimals) {
  return LatexPrinter(graph, name, decimals).text(id, 0);
}

std::vector<std::string> latex_terms(const ir::Graph& graph, NodeId id,
                                     const std::function<std::string(ir::SymbolId)>& name,
                                     const DecimalStyle& decimals) {
  const LatexPrinter printer(graph, name, decimals);
  return graph[id].kind == Kind::sum ? printer.terms(graph[id]) : std::vector<std::string>{printer.text(id, 0)};
}

}  // namespace gaussgen::lower
