#include "passes/prepare.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "ir/print.hpp"
#include "ir/traverse.hpp"
#include "passes/program.hpp"

namespace gaussgen::passes {

using ir::Expr;
using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::SymbolClass;
using ir::Term;

namespace {

bool is_symbol(const Graph& graph, NodeId id, SymbolClass symbol_class) {
  return graph[id].kind == Kind::symbol && graph.symbol(graph[id].symbol).symbol_class == symbol_class;
}

// Rational numbers are written in place, and the rounding unit costs nothing.
bool stays_in_place(const Graph& graph, NodeId id) {
  return graph[id].kind == Kind::constant || is_symbol(graph, id, SymbolClass::epsilon);
}

bool is_short(const Rational& coefficient) { return support::is_integer(coefficient); }

}  // namespace

PreparationSplit::PreparationSplit(Graph& graph, std::unordered_map<std::uint32_t, std::string> names)
    : graph_(graph), names_(std::move(names)), definitions_(graph) {}

NodeId PreparationSplit::operator()(NodeId root) {
  for (const NodeId id : ir::post_order(graph_, {root}, [this](NodeId node) { return memo_.contains(node); })) {
    if (!memo_.contains(id)) memo_[id] = varies(id) ? rebuilt(id) : id;
  }
  const NodeId result = known(root);
  return varies(root) || stays_in_place(graph_, root) ? result : prepared(root);
}

bool PreparationSplit::varies(NodeId id) {
  if (const bool* const found = varies_.find(id)) return *found;
  // Conditions have a type of their own, so they are not prepared, only what they compare or choose.
  const bool result = is_boolean(graph_, id) || depends(id);
  varies_[id] = result;
  return result;
}

bool PreparationSplit::depends(NodeId id) {
  const Node& node = graph_[id];
  if (node.kind == Kind::symbol) return ir::varies(graph_.symbol(node.symbol));
  return std::any_of(node.children.begin(), node.children.end(),
                     [this](NodeId child) { return is_boolean(graph_, child) ? depends(child) : varies(child); });
}

NodeId PreparationSplit::prepared(NodeId id) {
  if (const NodeId* const found = prepared_.find(id)) return *found;
  if (stays_in_place(graph_, id)) return id;
  const Node& node = graph_[id];
  const bool is_parameter = is_symbol(graph_, id, SymbolClass::parameter);
  const std::string name = name_of(id);
  const SymbolId symbol = is_parameter ? node.symbol : graph_.declare(SymbolClass::parameter, name);
  const NodeId value = is_parameter ? id : definitions_(Expr(graph_, id)).id();
  values_.push_back({symbol, value, name});
  const NodeId use = graph_.use(symbol);
  prepared_[id] = use;
  prepared_[use] = use;
  varies_[use] = false;
  if (!is_parameter) definitions_.replace(symbol, Expr(graph_, value));
  return use;
}

std::string PreparationSplit::name_of(NodeId id) const {
  if (const auto wanted = names_.find(id.index); wanted != names_.end()) return wanted->second;
  const Node& node = graph_[id];
  if (node.kind == Kind::named) return graph_.name(node);
  return node.kind == Kind::symbol ? graph_.symbol(node.symbol).name : graph_.label(id);
}

// Called for nodes that vary, after their children.
NodeId PreparationSplit::rebuilt(NodeId id) {
  if (stays(graph_[id])) return graph_[id].kind == Kind::named ? id : relabelled(id, id);
  const Node node = graph_[id];
  std::vector<NodeId> children;
  switch (node.kind) {
    case Kind::sum: return relabelled(id, rebuilt_sum(id));
    case Kind::product: return relabelled(id, rebuilt_product(id));
    case Kind::power: return relabelled(id, graph_.power(known(node.children[0]), node.value));
    case Kind::named: return graph_.kept_whole(known(node.children[0]), graph_.name(node));
    case Kind::function:
      for (const NodeId child : node.children) children.push_back(varies(child) ? known(child) : prepared(child));
      return relabelled(id, graph_.call_again(node, children));
    default: return id;
  }
}

// Most do: with parameters folded in, nearly all.
bool PreparationSplit::stays(const Node& node) {
  const bool has_same = std::all_of(node.children.begin(), node.children.end(),
                                    [this](NodeId child) { return varies(child) && known(child) == child; });
  if (!has_same || node.kind != Kind::sum) return has_same;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (!is_short(node.coefficients[i]) && has_constant_factor(graph_[node.children[i]])) return false;
  }
  return true;
}

bool PreparationSplit::has_constant_factor(const Node& node) {
  return node.kind == Kind::product &&
         std::any_of(node.children.begin(), node.children.end(), [this](NodeId factor) { return !varies(factor); });
}

NodeId PreparationSplit::relabelled(NodeId old, NodeId replacement) {
  const std::string label = graph_.label(old);
  return label.empty() ? replacement : graph_.named(replacement, label);
}

NodeId PreparationSplit::rebuilt_sum(NodeId id) {
  const Node node = graph_[id];
  std::vector<Term> constant;
  std::vector<Term> result;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (varies(node.children[i])) {
      result.push_back({1, rebuilt_term(node.coefficients[i], node.children[i])});
    } else {
      constant.push_back({node.coefficients[i], node.children[i]});
    }
  }
  if (constant.empty()) return graph_.linear(node.value, result);
  // A lone parameter keeps its whole factor outside: 2 m + x needs m only.
  if (constant.size() == 1 && node.value == 0 && is_short(constant[0].coefficient)) {
    result.push_back({constant[0].coefficient, prepared(constant[0].node)});
  } else {
    result.push_back({1, prepared(graph_.linear(node.value, constant))});
  }
  return graph_.linear(0, result);
}

PreparationSplit::Parts PreparationSplit::split_factors(NodeId product) {
  Parts parts;
  const Node node = graph_[product];
  for (const NodeId child : node.children) (varies(child) ? parts.varying : parts.constant).push_back(child);
  return parts;
}

NodeId PreparationSplit::rebuilt_term(const Rational& coefficient, NodeId node) {
  if (is_short(coefficient) || graph_[node].kind != Kind::product) return graph_.scale(coefficient, known(node));
  const Parts parts = split_factors(node);
  if (parts.constant.empty()) return graph_.scale(coefficient, known(node));
  // The sign stays outside: m/2 and -m/2 are prepared once.
  std::vector<NodeId> factors{prepared(graph_.scale(cln::abs(coefficient), graph_.product(parts.constant)))};
  for (const NodeId factor : parts.varying) factors.push_back(known(factor));
  return graph_.scale(coefficient < 0 ? -1 : 1, graph_.product(factors));
}

NodeId PreparationSplit::rebuilt_product(NodeId id) {
  const Parts parts = split_factors(id);
  std::vector<NodeId> factors;
  if (!parts.constant.empty()) factors.push_back(prepared(graph_.product(parts.constant)));
  for (const NodeId factor : parts.varying) factors.push_back(known(factor));
  return graph_.product(factors);
}

void PreparationSplit::touch(NodeId root) {
  for (const NodeId id : ir::post_order(graph_, {root})) {
    if (is_symbol(graph_, id, SymbolClass::parameter)) prepared(id);
  }
}

// A product that is only part of a larger one was split as well, so some values may have no use in the end.
std::vector<PreparedValue> PreparationSplit::values_in(const std::vector<NodeId>& roots) const {
  std::unordered_set<std::uint32_t> used;
  for (const NodeId id : ir::post_order(graph_, roots)) {
    if (graph_[id].kind == Kind::symbol) used.insert(graph_[id].symbol.index);
  }
  std::vector<PreparedValue> values;
  std::copy_if(values_.begin(), values_.end(), std::back_inserter(values),
               [&](const PreparedValue& value) { return used.count(value.symbol.index) != 0; });
  return values;
}

std::vector<std::string> violations(const Graph& graph, const PreparationSplit& split,
                                    const std::vector<NodeId>& roots) {
  std::vector<std::string> found;
  for (const PreparedValue& value : split.values_in(roots)) {
    const std::vector<NodeId> order = ir::post_order(graph, {value.value});
    if (ir::depends_on(graph, order, ir::varies).contains(value.value)) {
      found.push_back("prepared value that varies: " + ir::print(graph, value.value));
    }
  }
  const std::vector<NodeId> order = ir::post_order(graph, roots);
  const ir::NodeSet varying = ir::depends_on(graph, order, ir::varies);
  for (const NodeId id : order) {
    const Node& node = graph[id];
    if (!varying.contains(id) && !node.children.empty() && !is_boolean(graph, id)) {
      found.push_back("left unprepared: " + ir::print(graph, id));
    }
  }
  return found;
}

}  // namespace gaussgen::passes
