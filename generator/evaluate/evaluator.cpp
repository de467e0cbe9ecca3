#include "evaluate/evaluator.hpp"

#include <algorithm>

#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/arithmetic_paired.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "ir/print.hpp"
#include "ir/traverse.hpp"
#include "support/assert.hpp"

namespace gaussgen::evaluate {

using ir::Function;
using ir::Kind;
using ir::Node;
using ir::NodeId;

namespace {

bool is_logical(const Node& node) {
  return node.kind == Kind::function &&
         (ir::is_boolean(node.function) || node.function == Function::select || node.function == Function::piecewise);
}

/// Whether a value may be handed out.
template <class T>
bool is_known(const Arithmetic<T>&, const T&) {
  return true;
}

bool is_known(const Arithmetic<Paired>& arithmetic, const Paired& value) { return arithmetic.is_known(value); }

std::string name_of(const ir::Graph& graph, NodeId id) {
  const std::string& label = graph.label(id);
  return label.empty() ? ir::print_brief(graph, id) : label;
}

}  // namespace

template <class T>
void Evaluator<T>::bind(ir::SymbolId symbol, T value) {
  bound_.insert_or_assign(symbol.index, std::move(value));
  entries_.clear();
}

template <class T>
std::optional<T> Evaluator<T>::operator()(NodeId node) {
  if (!entries_.contains(node)) compute({node});
  return handed_out(node);
}

template <class T>
std::vector<std::optional<T>> Evaluator<T>::evaluate(const std::vector<NodeId>& nodes) {
  compute(nodes);
  std::vector<std::optional<T>> values;
  values.reserve(nodes.size());
  for (const NodeId node : nodes) values.push_back(handed_out(node));
  return values;
}

template <class T>
std::optional<T> Evaluator<T>::handed_out(NodeId node) const {
  const std::optional<T>& value = known(node).value;
  return value && is_known(arithmetic_, *value) ? value : std::nullopt;
}

template <class T>
std::optional<Trouble> Evaluator<T>::trouble(NodeId node) {
  compute({node});
  const Entry& entry = known(node);
  if (entry.value && is_known(arithmetic_, *entry.value)) return std::nullopt;
  if (entry.value) return Trouble{node, name_of(graph_, node), reason::k_rounding};
  return Trouble{entry.origin, name_of(graph_, entry.origin), entry.reason};
}

template <class T>
void Evaluator<T>::compute(const std::vector<NodeId>& nodes) {
  const auto is_known = [this](NodeId id) { return entries_.contains(id); };
  for (const NodeId id : ir::post_order(graph_, nodes, is_known)) {
    if (is_known(id)) continue;
    Entry entry = entry_of(id);
    entries_[id] = std::move(entry);
  }
}

template <class T>
typename Evaluator<T>::Entry Evaluator<T>::entry_of(NodeId id) const {
  const Node& node = graph_[id];
  if (node.kind == Kind::symbol) return of_symbol(id);
  if (is_logical(node)) return of_condition(id);
  if (const Entry* undefined = first_undefined(node)) return *undefined;
  std::vector<T> x;
  x.reserve(node.children.size());
  for (const NodeId child : node.children) x.push_back(*known(child).value);
  const Outcome<T> outcome = of_values(node, x);
  if (!outcome) return {std::nullopt, id, outcome.reason()};
  return {*outcome, {}, ""};
}

template <class T>
Outcome<T> Evaluator<T>::of_values(const Node& node, const std::vector<T>& x) const {
  switch (node.kind) {
    case Kind::sum: return arithmetic_.sum(node.value, node.coefficients, x);
    case Kind::product: return arithmetic_.product(x);
    case Kind::power: return arithmetic_.power(x[0], node.value);
    case Kind::function:
      if (node.function == Function::table) return looked_up(node, x[0]);
      return ir::is_choice(node.function) ? chosen(node.function, x) : arithmetic_.call(node.function, x);
    case Kind::named: return x[0];
    // Without operations; here it gets the check for overflow.
    default: return arithmetic_.sum(node.value, {}, {});
  }
}

template <class T>
Outcome<T> Evaluator<T>::chosen(Function function, const std::vector<T>& x) const {
  const T zero = arithmetic_.number(Rational(0));
  const bool is_negative = arithmetic_.less(x[0], zero);
  switch (function) {
    case Function::abs: return is_negative ? arithmetic_.sum(0, {-1}, x) : Outcome<T>(x[0]);
    case Function::sign:
      return is_negative || arithmetic_.less(zero, x[0]) ? arithmetic_.number(is_negative ? -1 : 1) : zero;
    case Function::min: return arithmetic_.less(x[1], x[0]) ? x[1] : x[0];
    case Function::max: return arithmetic_.less(x[0], x[1]) ? x[1] : x[0];
    default: GAUSS_ASSERT(false, "function={}", ir::name_of(function)); return zero;
  }
}

// In the order of emitted code: the last piece that begins at or before x, then Horner's rule.
template <class T>
Outcome<T> Evaluator<T>::looked_up(const Node& node, const T& x) const {
  const std::vector<support::Table::Piece>& pieces = graph_.table(node.table).pieces;
  const auto is_beyond = [this](const T& at, const support::Table::Piece& piece) {
    return arithmetic_.less(at, arithmetic_.number(piece.begin));
  };
  const auto next = std::upper_bound(pieces.begin(), pieces.end(), x, is_beyond);
  const support::Table::Piece& piece = next == pieces.begin() ? *next : *(next - 1);
  const std::vector<Rational> coefficients = support::derivative(piece, support::to_int(node.value));
  const Outcome<T> u = arithmetic_.sum(-piece.begin, {1}, {x});
  Outcome<T> value = arithmetic_.sum(coefficients.back(), {}, {});
  for (std::size_t i = coefficients.size() - 1; i-- > 0 && u && value;) {
    const Outcome<T> product = arithmetic_.product({*u, *value});
    value = product ? arithmetic_.sum(coefficients[i], {1}, {*product}) : product;
  }
  return u ? value : u;
}

template <class T>
typename Evaluator<T>::Entry Evaluator<T>::of_symbol(NodeId id) const {
  const ir::SymbolId symbol = graph_[id].symbol;
  if (const auto found = bound_.find(symbol.index); found != bound_.end()) return {found->second, {}, ""};
  switch (graph_.symbol(symbol).symbol_class) {
    case ir::SymbolClass::pi: return {arithmetic_.pi(), {}, ""};
    case ir::SymbolClass::epsilon: return {arithmetic_.epsilon(), {}, ""};
    default: return {std::nullopt, id, reason::k_unbound};
  }
}

template <class T>
typename Evaluator<T>::Entry Evaluator<T>::of_condition(NodeId id) const {
  const Node& node = graph_[id];
  const auto is_true = [this](NodeId child) { return known(child).value && arithmetic_.is_true(*known(child).value); };
  const Entry* undefined = first_undefined(node);
  switch (node.function) {
    case Function::not_finite: return boolean(undefined != nullptr);
    case Function::any:
      for (const NodeId child : node.children) {
        if (is_true(child)) return boolean(true);
      }
      return undefined != nullptr ? *undefined : boolean(false);
    case Function::piecewise:
    case Function::select:
      if (!known(node.children[0]).value) return known(node.children[0]);
      return known(node.children[is_true(node.children[0]) ? 1 : 2]);
    default: {
      if (undefined != nullptr) return *undefined;
      const T& a = *known(node.children[0]).value;
      const T& b = *known(node.children[1]).value;
      return boolean(node.function == Function::less ? arithmetic_.less(a, b) : !arithmetic_.less(b, a));
    }
  }
}

template <class T>
const typename Evaluator<T>::Entry* Evaluator<T>::first_undefined(const Node& node) const {
  for (const NodeId child : node.children) {
    if (!known(child).value) return &known(child);
  }
  return nullptr;
}

template <class T>
typename Evaluator<T>::Entry Evaluator<T>::boolean(bool value) const {
  return {arithmetic_.number(Rational(value ? 1 : 0)), {}, ""};
}

template class Evaluator<double>;
template class Evaluator<long double>;
template class Evaluator<cln::cl_F>;
template class Evaluator<Paired>;
template class Evaluator<Scaled<double>>;
template class Evaluator<Scaled<long double>>;
template class Evaluator<Scaled<cln::cl_F>>;

}  // namespace gaussgen::evaluate
