#include "evaluate/evaluator.hpp"

#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "ir/print.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::evaluate {

using ir::Function;
using ir::Kind;
using ir::Node;
using ir::NodeId;

namespace {

bool is_logical(const Node& node) {
  return node.kind == Kind::function && (ir::is_boolean(node.function) || node.function == Function::select);
}

std::string name_of(const ir::Graph& graph, NodeId id) {
  if (!graph[id].name.empty()) return graph[id].name;
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
  compute({node});
  return known(node).value;
}

template <class T>
std::vector<std::optional<T>> Evaluator<T>::evaluate(const std::vector<NodeId>& nodes) {
  compute(nodes);
  std::vector<std::optional<T>> values;
  values.reserve(nodes.size());
  for (const NodeId node : nodes) values.push_back(known(node).value);
  return values;
}

template <class T>
std::optional<Trouble> Evaluator<T>::trouble(NodeId node) {
  compute({node});
  const Entry& entry = known(node);
  if (entry.value) return std::nullopt;
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
    case Kind::function: return arithmetic_.call(node.function, x);
    case Kind::named: return x[0];
    // Without operations; here it gets the check for overflow.
    default: return arithmetic_.sum(node.value, {}, {});
  }
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
template class Evaluator<Scaled<double>>;
template class Evaluator<Scaled<long double>>;
template class Evaluator<Scaled<cln::cl_F>>;

}  // namespace gaussgen::evaluate
