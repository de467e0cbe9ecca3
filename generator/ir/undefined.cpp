#include "ir/undefined.hpp"

#include <algorithm>

namespace gaussgen::ir {

namespace {

bool may_ignore_arguments(Function function) {
  return function == Function::any || function == Function::select || function == Function::piecewise ||
         function == Function::not_finite;
}

bool is_pole_of_power(const Node& base, const Rational& exponent) {
  if (base.kind != Kind::constant) return false;
  return (base.value == 0 && exponent < 0) || (base.value < 0 && !support::is_integer(exponent));
}

bool is_outside_domain(const Graph& graph, const Node& node) {
  const auto is_constant = [&](NodeId id) { return graph[id].kind == Kind::constant; };
  if (!std::all_of(node.children.begin(), node.children.end(), is_constant)) return false;
  const auto value = [&](std::size_t i) { return graph[node.children[i]].value; };
  switch (node.function) {
    case Function::log: return value(0) <= 0;
    case Function::asin:
    case Function::acos: return cln::abs(value(0)) > 1;
    case Function::atan2: return value(0) == 0 && value(1) == 0;
    default: return false;
  }
}

}  // namespace

bool has_no_value(const Graph& graph, const Node& node) {
  const bool is_function = node.kind == Kind::function;
  const auto is_undefined = [&](NodeId id) { return graph.is_undefined(id); };
  if (is_function && node.function == Function::piecewise && is_undefined(node.children[0])) return true;
  if (is_function && may_ignore_arguments(node.function)) return false;
  if (std::any_of(node.children.begin(), node.children.end(), is_undefined)) return true;
  if (node.kind == Kind::power) return is_pole_of_power(graph[node.children[0]], node.value);
  return is_function && is_outside_domain(graph, node);
}

}  // namespace gaussgen::ir
