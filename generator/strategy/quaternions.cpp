#include "strategy/quaternions.hpp"

#include "strategy/inner.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using support::Rational;

namespace {

Expr any_outside(ir::Graph& graph, const Vector& values, const Rational& low, const Rational& high) {
  std::vector<Expr> conditions;
  for (const Expr value : values) {
    conditions.push_back(less(value, {graph, graph.constant(low)}));
    conditions.push_back(less({graph, graph.constant(high)}, value));
  }
  return any(graph, conditions);
}

}  // namespace

Vector squared_norms(const kinematics::Symbols& symbols, const Vector& configuration) {
  Vector result;
  for (const kinematics::ConfigurationIndex first : symbols.first_quaternion_component) {
    const auto begin = configuration.begin() + static_cast<std::ptrdiff_t>(first.value);
    const Vector e(begin, begin + 4);
    result.push_back(inner(e[0].graph(), e, e).named("norm_squared"));
  }
  return result;
}

void normalise(const kinematics::Symbols& symbols, Vector& configuration) {
  const Vector norms = squared_norms(symbols, configuration);
  for (std::size_t k = 0; k < norms.size(); ++k) {
    const std::size_t first = symbols.first_quaternion_component[k].value;
    const Expr scale = pow(norms[k], Rational(-1) / 2).named("unit");
    for (std::size_t i = 0; i < 4; ++i) configuration[first + i] = configuration[first + i] * scale;
  }
}

Expr is_off_unit_length(ir::Graph& graph, const Vector& squared_norms) {
  return any_outside(graph, squared_norms, Rational(63) / 64, Rational(65) / 64);
}

Expr is_beyond_scaling(ir::Graph& graph, const Vector& squared_norms) {
  const Rational range = cln::expt_pos(cln::cl_I(2), 40);
  return any_outside(graph, squared_norms, 1 / range, range);
}

}  // namespace gaussgen::strategy
