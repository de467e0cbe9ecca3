#pragma once

#include "ir/contract.hpp"
#include "strategy/ldl.hpp"

namespace gaussgen::strategy {

/// Σ a_i b_i
inline ir::Expr inner(ir::Graph& graph, const Vector& a, const Vector& b) {
  std::vector<std::pair<ir::Expr, ir::Expr>> pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].is_zero() && !b[i].is_zero()) pairs.emplace_back(a[i], b[i]);
  }
  return ir::contract(graph, pairs);
}

}  // namespace gaussgen::strategy
