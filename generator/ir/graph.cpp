#include "ir/graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/undefined.hpp"
#include "support/assert.hpp"

namespace gaussgen::ir {

namespace {

constexpr std::size_t k_mix = 0x9E3779B97F4A7C15U;

std::size_t mix(std::size_t seed, std::size_t value) {
  return (seed ^ (value + k_mix + (seed << 6U) + (seed >> 2U))) * k_mix;
}

// Child ids enter the hash, so its value depends on creation order; it is used for look-up only.
std::size_t hash_of(const Node& node) {
  std::size_t seed = static_cast<std::size_t>(node.kind);
  seed = mix(seed, static_cast<std::size_t>(node.function));
  seed = mix(seed, node.symbol.index);
  seed = mix(seed, support::hash(node.value));
  for (const NodeId child : node.children) seed = mix(seed, child.index);
  for (const Rational& coefficient : node.coefficients) seed = mix(seed, support::hash(coefficient));
  return seed;
}

bool same(const Node& a, const Node& b) {
  return a.kind == b.kind && a.function == b.function && a.symbol == b.symbol && a.value == b.value &&
         a.children == b.children && a.coefficients == b.coefficients;
}

bool is_many_term_sum(const Node& node) {
  return node.kind == Kind::sum && node.children.size() + (node.value == 0 ? 0U : 1U) > 1;
}

// Only a sum can be flattened into its users, and only then would its additions be done again by each of them.
bool can_be_flattened(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  if (is_many_term_sum(node)) return true;
  if (node.kind == Kind::sum) return can_be_flattened(graph, node.children[0]);
  if (node.kind != Kind::product) return false;
  for (const NodeId factor : node.children) {
    if (is_many_term_sum(graph[factor])) return true;
  }
  return false;
}

}  // namespace

SymbolId Graph::declare(SymbolClass symbol_class, std::string name, bool is_of_unit_quaternion) {
  symbols_.push_back({symbol_class, std::move(name), is_of_unit_quaternion});
  return SymbolId{static_cast<std::uint32_t>(symbols_.size() - 1)};
}

TableId Graph::declare(std::shared_ptr<const support::Table> table) {
  tables_.push_back(std::move(table));
  return TableId{static_cast<std::uint32_t>(tables_.size() - 1)};
}

NodeId Graph::intern(Node node) {
  const auto hash = static_cast<std::uint32_t>(hash_of(node) >> 32U);
  const auto is_same = [&](NodeId known) { return same(nodes_[known.index], node); };
  if (const NodeId* const known = index_.find(hash, is_same)) return *known;
  if (nodes_.size() >= most_nodes_) throw TooManyNodes(fmt::format("more than {} nodes", most_nodes_));
  const NodeId id{static_cast<std::uint32_t>(nodes_.size())};
  undefined_.push_back(has_no_value(*this, node));
  varies_.push_back(has_variable(node));
  nodes_.push_back(std::move(node));
  index_.insert(hash, id);
  return id;
}

bool Graph::has_variable(const Node& node) const {
  if (node.kind == Kind::symbol) return ir::varies(symbols_[node.symbol.index]);
  return std::any_of(node.children.begin(), node.children.end(), [this](NodeId child) { return varies(child); });
}

NodeId Graph::constant(const Rational& value) {
  Node node;
  node.kind = Kind::constant;
  node.value = value;
  return intern(std::move(node));
}

NodeId Graph::use(SymbolId id) {
  GAUSS_ASSERT(id.index < symbols_.size(), "symbol={} of {}", id.index, symbols_.size());
  Node node;
  node.kind = Kind::symbol;
  node.symbol = id;
  return intern(std::move(node));
}

NodeId Graph::named(NodeId id, const std::string& name) {
  const Node& node = (*this)[id];
  switch (node.kind) {
    case Kind::constant:
    case Kind::symbol:
    case Kind::named: return id;
    case Kind::function:  // sin_theta says more than the name of a matrix entry that happens to be sin(theta)
      if (node.function != Function::select && node.function != Function::piecewise) return id;
      break;
    default: break;
  }
  if (!can_be_flattened(*this, id)) {
    relabel(id, name);
    return id;
  }
  return kept_whole(id, name);
}

NodeId Graph::kept_whole(NodeId id, const std::string& name) {
  const Kind kind = (*this)[id].kind;
  if (kind == Kind::constant || kind == Kind::symbol || kind == Kind::named) return id;
  // One wrapper for one value: under two names it would not cancel against itself.
  if (const NodeId* const known = wrappers_.find(id)) return *known;
  Node wrapper;
  wrapper.kind = Kind::named;
  wrapper.children = {id};
  wrapper.name = names_.insert(name);
  const NodeId result = intern(std::move(wrapper));
  wrappers_[id] = result;
  return result;
}

void Graph::relabel(NodeId id, const std::string& name) {
  if (!labels_.contains(id)) labels_[id] = names_.insert(name);
}

const std::string& Graph::label(NodeId id) const {
  if ((*this)[id].kind == Kind::named) return name((*this)[id]);
  const NameId* const found = labels_.find(id);
  return names_[found == nullptr ? NameId{} : *found];
}

bool Graph::is_constant(NodeId id, int value) const {
  const Node& node = (*this)[id];
  return node.kind == Kind::constant && node.value == value;
}

}  // namespace gaussgen::ir
