#include "passes/series.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "ir/node_table.hpp"
#include "ir/traverse.hpp"
#include "passes/share.hpp"
#include "support/assert.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;

namespace {

class SeriesBuilder {
 public:
  SeriesBuilder(Graph& graph, const std::function<bool(ir::SymbolId)>& varies, ir::SymbolId time)
      : graph_(graph), is_variable_(varies), time_(time) {}

  Series run(const std::vector<NodeId>& roots) {
    waiting_.assign(roots.rbegin(), roots.rend());
    while (!waiting_.empty()) {
      const NodeId root = unwrapped(graph_, waiting_.back());
      waiting_.pop_back();
      if (depends(root)) walk(root);
    }
    for (SeriesValue& value : result_.values) number_columns(value);
    ir::NodeSet seen;
    std::vector<NodeId> once;
    for (const NodeId id : result_.at_start) {
      if (!seen.contains(id)) once.push_back(id);
      seen.insert(id);
    }
    result_.at_start = std::move(once);
    return std::move(result_);
  }

 private:
  // ---- Order

  // Without recursion, since the depth of the graph grows with the model.
  void walk(NodeId root) {
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
      const NodeId id = stack.back();
      if (described_.count(id.index) == 0) {
        const SeriesValue& value = described_.emplace(id.index, describe(id)).first->second;
        for (const NodeId operand : value.operands) {
          if (depends(operand) && described_.count(operand.index) == 0) stack.push_back(operand);
        }
      } else {
        stack.pop_back();
        if (done_.contains(id)) continue;
        done_.insert(id);
        result_.values.push_back(described_.at(id.index));
      }
    }
  }

  bool depends(NodeId id) {
    for (const NodeId below : ir::post_order(graph_, {id}, [&](NodeId one) { return depends_.contains(one); })) {
      if (depends_.contains(below)) continue;
      const Node& node = graph_[below];
      bool found = node.kind == Kind::symbol && is_variable_(node.symbol);
      for (const NodeId child : node.children) found = found || depends_[child];
      depends_[below] = found;
    }
    return depends_[id];
  }

  // ---- What a value is

  NodeId plain(NodeId id) const { return unwrapped(graph_, id); }

  SeriesValue describe(NodeId id) {
    const Node& node = graph_[id];
    switch (node.kind) {
      case Kind::symbol: return {id, node.symbol == time_ ? SeriesValue::Kind::time : SeriesValue::Kind::state};
      case Kind::sum: return sum(id);
      case Kind::product: return product(id);
      case Kind::power: return power(id);
      case Kind::function: return function(id);
      case Kind::constant:
      case Kind::named: break;
    }
    GAUSS_ASSERT(false, "node {} is of kind {}", id.index, static_cast<int>(node.kind));
    return {id, SeriesValue::Kind::sum};
  }

  SeriesValue sum(NodeId id) {
    SeriesValue value{id, SeriesValue::Kind::sum};
    const ir::Node node = graph_[id];
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      if (!depends(node.children[i])) continue;
      value.operands.push_back(plain(node.children[i]));
      value.coefficients.push_back(node.coefficients[i]);
    }
    return value;
  }

  SeriesValue of(NodeId id, SeriesValue::Kind kind, std::initializer_list<NodeId> operands) {
    SeriesValue value{id, kind};
    for (const NodeId operand : operands) value.operands.push_back(plain(operand));
    return value;
  }

  // Factor by factor; a divisor takes one column, where its reciprocal and a product would take two.
  SeriesValue product(NodeId id) {
    std::vector<NodeId> constant, varying;
    for (const NodeId child : listed(graph_[id].children)) (depends(child) ? varying : constant).push_back(child);
    if (!constant.empty()) {
      const NodeId factor = graph_.product(constant);
      result_.at_start.push_back(factor);
      return of(id, SeriesValue::Kind::scaled, {factor, graph_.product(varying)});
    }
    const auto divisor = std::find_if(varying.rbegin(), varying.rend(), [&](NodeId one) { return is_reciprocal(one); });
    if (divisor != varying.rend()) {
      const NodeId below = plain(graph_[plain(*divisor)].children[0]);
      varying.erase(std::next(divisor).base());
      return quotient(id, graph_.product(varying), below);
    }
    const auto [a, b] = halves(varying);
    return multiplied(id, a, b);
  }

  bool is_reciprocal(NodeId id) const {
    const Node& node = graph_[plain(id)];
    return node.kind == Kind::power && node.value == -1;
  }

  /// Two factors, one of which is there already, if any is.
  std::pair<NodeId, NodeId> halves(std::vector<NodeId> factors) {
    if (factors.size() > 2) {
      for (std::size_t i = 0; i < factors.size(); ++i) {
        for (std::size_t j = i + 1; j < factors.size(); ++j) {
          const NodeId pair = graph_.product({factors[i], factors[j]});
          if (described_.count(plain(pair).index) == 0) continue;
          factors.erase(factors.begin() + static_cast<std::ptrdiff_t>(j));
          factors.erase(factors.begin() + static_cast<std::ptrdiff_t>(i));
          return {pair, graph_.product(factors)};
        }
      }
    }
    const NodeId last = factors.back();
    factors.pop_back();
    return {graph_.product(factors), last};
  }

  SeriesValue multiplied(NodeId id, NodeId a, NodeId b) {
    result_.at_start.insert(result_.at_start.end(), {plain(a), plain(b)});
    return of(id, SeriesValue::Kind::product, {a, b});
  }

  SeriesValue quotient(NodeId id, NodeId above, NodeId below) {
    SeriesValue value = of(id, SeriesValue::Kind::quotient, {above, below});
    divide_by(graph_.power(below, -1), value);
    result_.at_start.push_back(id);
    return value;
  }

  void divide_by(NodeId inverse, SeriesValue& value) {
    value.inverse = plain(inverse);
    result_.at_start.push_back(value.inverse);
  }

  SeriesValue power(NodeId id) {
    const NodeId base = plain(graph_[id].children[0]);
    const Rational exponent = graph_[id].value;
    if (exponent == -1) return quotient(id, graph_.constant(1), base);
    const Rational half = Rational(1) / 2;
    if (exponent == half) {
      SeriesValue value = of(id, SeriesValue::Kind::square_root, {base});
      divide_by(graph_.scale(half, graph_.power(base, -half)), value);
      return value;
    }
    // u p' = e u' p
    if (exponent < 0 || !support::is_integer(exponent)) return rates(id, {base}, {{exponent, id, base}}, {base});
    const int whole = support::to_int(exponent);
    if (whole % 2 != 0) return multiplied(id, base, graph_.power(base, whole - 1));
    const NodeId root = plain(graph_.power(base, whole / 2));
    result_.at_start.push_back(root);
    return of(id, SeriesValue::Kind::square, {root});
  }

  /// divisor y' = Σ terms; factors that are no operands follow.
  SeriesValue rates(NodeId id, std::initializer_list<NodeId> operands, std::vector<SeriesValue::Term> terms,
                    std::vector<NodeId> divisor) {
    SeriesValue value = of(id, SeriesValue::Kind::rates, operands);
    for (SeriesValue::Term& term : terms) {
      term.factor = plain(term.factor);
      term.of = plain(term.of);
      if (depends(term.factor)) waiting_.push_back(term.factor);
      result_.at_start.push_back(term.factor);
    }
    for (NodeId& one : divisor) {
      one = plain(one);
      waiting_.push_back(one);
      divide_by(graph_.power(one, -1), value);
    }
    value.terms = std::move(terms);
    value.divisor = std::move(divisor);
    return value;
  }

  NodeId call(Function function, NodeId argument) { return graph_.call(function, {argument}); }
  NodeId square(NodeId x) { return graph_.power(x, 2); }
  NodeId one_plus(int factor, NodeId x) { return graph_.linear(1, {{factor, x}}); }

  SeriesValue function(NodeId id) {
    const ir::Node node = graph_[id];
    const NodeId u = plain(node.children[0]), one = graph_.constant(1);
    switch (node.function) {
      case Function::sin: return rates(id, {u}, {{1, call(Function::cos, u), u}}, {});
      case Function::cos: return rates(id, {u}, {{-1, call(Function::sin, u), u}}, {});
      case Function::sinh: return rates(id, {u}, {{1, call(Function::cosh, u), u}}, {});
      case Function::cosh: return rates(id, {u}, {{1, call(Function::sinh, u), u}}, {});
      case Function::exp: return rates(id, {u}, {{1, id, u}}, {});
      case Function::tan: return rates(id, {u}, {{1, one_plus(1, square(id)), u}}, {});
      case Function::tanh: return rates(id, {u}, {{1, one_plus(-1, square(id)), u}}, {});
      case Function::log: return rates(id, {u}, {{1, one, u}}, {u});
      case Function::asin: return arc(id, u, 1);
      case Function::acos: return arc(id, u, -1);
      case Function::atan: return rates(id, {u, one_plus(1, square(u))}, {{1, one, u}}, {one_plus(1, square(u))});
      case Function::atan2: return angle(id, u, plain(node.children[1]));
      case Function::select: result_.at_start.push_back(node.children[0]); return chosen(id, node);
      default: break;
    }
    result_.edges.push_back(id);
    return {id, SeriesValue::Kind::sum};
  }

  SeriesValue chosen(NodeId id, const Node& node) {
    const bool is_of_pivot = graph_.is_zero(node.children[1]) || graph_.is_zero(node.children[2]);
    if (depends(node.children[0]) && !is_of_pivot) result_.edges.push_back(id);
    SeriesValue value = of(id, SeriesValue::Kind::choice, {node.children[1], node.children[2]});
    value.condition = node.children[0];
    return value;
  }

  /// sqrt(1 - u^2) y' = sign u'
  SeriesValue arc(NodeId id, NodeId u, int sign) {
    const NodeId root = graph_.power(one_plus(-1, square(u)), Rational(1) / 2);
    return rates(id, {u, root}, {{sign, graph_.constant(1), u}}, {root});
  }

  /// (x^2 + y^2) a' = x y' - y x'
  SeriesValue angle(NodeId id, NodeId y, NodeId x) {
    const NodeId size = graph_.sum({square(x), square(y)});
    return rates(id, {y, x, size}, {{1, x, y}, {-1, y, x}}, {size});
  }

  // ---- Columns

  void number_columns(SeriesValue& value) {
    using Of = SeriesValue::Kind;
    if (value.kind == Of::product) value.column = column(value.operands[0], false, value.operands[1]);
    if (value.kind == Of::quotient) value.column = column(value.id, false, value.operands[1]);
    if (value.kind == Of::square) value.column = column_of_square(value.operands[0]);
    if (value.kind == Of::square_root) value.column = column_of_square(value.id);
    for (SeriesValue::Term& term : value.terms) {
      term.has_column = depends(term.factor) && depends(term.of);
      if (term.has_column) term.column = column(term.of, true, term.factor);
    }
    if (!value.divisor.empty()) value.column = column(value.id, true, value.divisor.front());
  }

  std::size_t column(NodeId left, bool is_rate, NodeId right) {
    const auto [place, is_new] =
        columns_.emplace(std::make_tuple(left.index, is_rate, right.index), result_.products.size());
    if (is_new) result_.products.push_back({left, is_rate, right});
    return place->second;
  }

  std::size_t column_of_square(NodeId operand) {
    const auto known = std::find(result_.squares.begin(), result_.squares.end(), operand);
    const auto place = static_cast<std::size_t>(known - result_.squares.begin());
    if (known == result_.squares.end()) result_.squares.push_back(operand);
    return place;
  }

  Graph& graph_;
  const std::function<bool(ir::SymbolId)>& is_variable_;
  ir::SymbolId time_;
  Series result_;
  std::vector<NodeId> waiting_;
  std::map<std::uint32_t, SeriesValue> described_;
  ir::NodeSet done_;
  ir::NodeTable<bool> depends_;
  std::map<std::tuple<std::uint32_t, bool, std::uint32_t>, std::size_t> columns_;
};

}  // namespace

Series series_of(Graph& graph, const std::vector<NodeId>& roots, const std::function<bool(ir::SymbolId)>& varies,
                 ir::SymbolId time) {
  return SeriesBuilder(graph, varies, time).run(roots);
}

}  // namespace gaussgen::passes
