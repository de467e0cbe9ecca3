#include "strategy/position_size.hpp"

#include "ir/differentiate.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;

Expr left_by_all(const Vector& b, const Vector& inertia, Expr size_of_all, Expr epsilon) {
  ir::Graph& graph = epsilon.graph();
  const Expr zero(graph, graph.constant(0));
  Expr response = zero;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (b[i].is_zero() || inertia[i].is_zero()) continue;
    response += select(less(zero, inertia[i]), pow(b[i], 2) / inertia[i], zero);
  }
  return support::Rational(10'000) * pow(epsilon, 2) * size_of_all * response;
}

Expr PositionSize::number(int value) const {
  ir::Graph& graph = dynamics_.g[0][0].graph();
  return {graph, graph.constant(value)};
}

Expr PositionSize::symbol(std::size_t i) const {
  ir::Graph& graph = dynamics_.g[0][0].graph();
  return {graph, graph.use(dynamics_.kinematics->symbols.configuration[ConfigurationIndex{i}].symbol)};
}

Expr PositionSize::of_speed(FreeIndex i) const {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  Expr size = number(symbols.speeds[i].is_of_length() ? 0 : 1);
  if (i.value < symbols.plain_count() && !symbols.speeds[i].replaces_rate)
    size += pow(start_[i.value], 2) + pow(symbol(i.value), 2);
  return size;
}

/// ∂f/∂q of a coordinate whose rate is no speed, times the size of q.
Expr PositionSize::along_coordinate(std::size_t mu, std::size_t i) const {
  const kinematics::ConfigurationVariable& q = dynamics_.kinematics->symbols.configuration[ConfigurationIndex{i}];
  const Expr gradient = ir::partial(*dynamics_.kinematics->constraints[ConstraintIndex{mu}].f, q.symbol);
  if (gradient.is_zero()) return number(0);
  const Expr size = pow(start_[i], 2) + pow(symbol(i), 2);
  return pow(gradient, 2) * (size + number(q.unit == "m" ? 0 : 1));
}

Expr PositionSize::of_row(std::size_t mu) const {
  const kinematics::Symbols& symbols = dynamics_.kinematics->symbols;
  const Vector& b = dynamics_.b[mu];
  Expr size = number(0);
  for (const FreeIndex i : symbols.speeds.indices()) {
    if (!b[i.value].is_zero()) size += pow(b[i.value], 2) * of_speed(i);
  }
  for (const FreeIndex i : symbols.speeds.indices()) {
    if (symbols.speeds[i].replaces_rate) size += along_coordinate(mu, i.value);
  }
  return size;
}

}  // namespace gaussgen::strategy
