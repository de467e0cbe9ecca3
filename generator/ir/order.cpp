// Canonical order of nodes: declaration order of symbols, then structure (architecture, decision 1).

#include "ir/order.hpp"

#include <algorithm>
#include <utility>

#include "ir/graph.hpp"
#include "support/characters.hpp"

namespace gaussgen::ir {

using support::is_digit;

namespace {

int three_way(const Rational& a, const Rational& b) { return a < b ? -1 : (b < a ? 1 : 0); }

template <class T>
int three_way(const T& a, const T& b) {
  return a < b ? -1 : (b < a ? 1 : 0);
}

int rank(Kind kind) {
  switch (kind) {
    case Kind::constant: return 0;
    case Kind::symbol: return 1;
    case Kind::named: return 2;
    case Kind::function: return 3;
    case Kind::power: return 4;
    case Kind::product: return 5;
    case Kind::sum: return 6;
  }
  return 7;
}

/// Pairs further down than this are looked up: where deep expressions meet, they meet again and again.
constexpr int k_steps_before_lookup = 4;

std::uint64_t key_of(NodeId lower, NodeId upper) { return (std::uint64_t{lower.index} << 32U) | upper.index; }

std::size_t digits_end(const std::string& text, std::size_t from) {
  while (from < text.size() && is_digit(text[from])) ++from;
  return from;
}

}  // namespace

int compare_natural(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const std::size_t i_end = digits_end(a, i);
      const std::size_t j_end = digits_end(b, j);
      if (i_end - i != j_end - j) return i_end - i < j_end - j ? -1 : 1;
      const int digits = a.compare(i, i_end - i, b, j, j_end - j);
      if (digits != 0) return digits;
      i = i_end;
      j = j_end;
    } else {
      if (a[i] != b[j]) return three_way(a[i], b[j]);
      ++i;
      ++j;
    }
  }
  return three_way(a.size() - i, b.size() - j);
}

// Different nodes differ somewhere: the order of two is that of the first of their parts that differ. So this needs no stack.
int Graph::compare(NodeId a, NodeId b) const {
  if (a == b) return 0;
  std::vector<std::pair<NodeId, NodeId>> path;
  std::optional<int> order;
  for (int step = 0; !order; ++step) {
    if (step < k_steps_before_lookup) {
      order = step_down(a, b);
      continue;
    }
    const bool is_swapped = b.index < a.index;
    const auto known = orders_.find(is_swapped ? key_of(b, a) : key_of(a, b));
    if (known != orders_.end()) {
      order = is_swapped ? -known->second : known->second;
    } else {
      path.emplace_back(a, b);
      order = step_down(a, b);
    }
  }
  for (const auto& [left, right] : path) {
    const bool is_swapped = right.index < left.index;
    orders_.emplace(is_swapped ? key_of(right, left) : key_of(left, right), is_swapped ? -*order : *order);
  }
  return *order;
}

std::optional<int> Graph::step_down(NodeId& a, NodeId& b) const {
  const Node& left = (*this)[a];
  const Node& right = (*this)[b];
  const auto go_to = [&](NodeId below_a, NodeId below_b) {
    a = below_a;
    b = below_b;
    return std::nullopt;
  };
  // A power stands beside its base, so that x, x^2, y appear in this order.
  if (left.kind == Kind::power || right.kind == Kind::power) {
    const NodeId left_base = left.kind == Kind::power ? left.children[0] : a;
    const NodeId right_base = right.kind == Kind::power ? right.children[0] : b;
    if (left_base != right_base) return go_to(left_base, right_base);
    const Rational one = 1;
    return three_way(left.kind == Kind::power ? left.value : one, right.kind == Kind::power ? right.value : one);
  }
  if (left.kind != right.kind) return three_way(rank(left.kind), rank(right.kind));
  if (left.kind == Kind::symbol) {
    const Symbol& x = symbol(left.symbol);
    const Symbol& y = symbol(right.symbol);
    if (x.symbol_class != y.symbol_class) return three_way(x.symbol_class, y.symbol_class);
    return three_way(left.symbol.index, right.symbol.index);
  }
  if (left.kind == Kind::named && left.name != right.name) return compare_natural(name(left), name(right));
  if (left.function != right.function) return three_way(left.function, right.function);
  if (left.function == Function::table && !(left.table == right.table)) {
    return three_way(left.table.index, right.table.index);
  }
  // Children, then coefficients, then the value.
  const auto [differing, other] =
      std::mismatch(left.children.begin(), left.children.end(), right.children.begin(), right.children.end());
  if (differing != left.children.end() && other != right.children.end()) return go_to(*differing, *other);
  if (left.children.size() != right.children.size()) return three_way(left.children.size(), right.children.size());
  for (std::size_t i = 0; i < left.coefficients.size(); ++i) {
    if (const int order = three_way(left.coefficients[i], right.coefficients[i]); order != 0) return order;
  }
  return three_way(left.value, right.value);
}

}  // namespace gaussgen::ir
