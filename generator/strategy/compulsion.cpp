#include "strategy/compulsion.hpp"

#include <algorithm>
#include <numeric>

#include "strategy/inner.hpp"
#include "strategy/metric.hpp"
#include "strategy/reactions.hpp"
#include "strategy/release.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::BodyMotion;

namespace {

Vector3 combination(const support::Indexed<kinematics::FullIndex, Vector3>& columns, const Vector& z) {
  Vector3 sum = ir::zero3(z[0].graph());
  for (std::size_t i = 0; i < z.size(); ++i) sum = sum + z[i] * columns[kinematics::FullIndex{i}];
  return sum;
}

Vector3 along_axes_of_omega(const BodyMotion& body, const Vector3& in_space) {
  return body.rotation.axes == model::Axes::space ? in_space : ir::multiply(transposed(body.rotation.matrix), in_space);
}

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

// All of y, or only the free coordinates where G has no inverse, as where held ones repeat what others do: then forces along held
// coordinates stay out of Z, which changes its value by a constant and its minimum not at all. Nothing where the free ones repeat
// each other.
std::optional<std::vector<std::size_t>> spreading_coordinates(const Dynamics& dynamics) {
  const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
  for (const std::size_t count : {symbols.full_count(), symbols.free_count()}) {
    if (is_invertible(dynamics, first(count))) return first(count);
  }
  return std::nullopt;
}

// Of forces that no body feels. What acts on parts without mass does so along free coordinates only: along held ones these parts are
// held.
Vector forces_without_body(const Dynamics& dynamics) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  Vector spread = kinematics.other_force.values();
  for (const kinematics::HeldIndex j : kinematics.symbols.held.indices()) {
    const kinematics::FullIndex row = kinematics.symbols.full(j);
    spread[row.value] -= kinematics.carried_force[row];
  }
  return spread;
}

}  // namespace

Expr square_in_inverse_inertia(const NamedInertia& inertia, const Vector3& n, Expr epsilon, Steps& steps) {
  const ir::Matrix3& I = inertia.tensor;
  if (inertia.is_isotropic) return dot(n, n) * pow(I[0][0], -1);
  Matrix rows;
  for (const Vector3& row : I) rows.push_back({row[0], row[1], row[2]});
  const Ldl ldl(rows, {"x", "y", "z"}, "I_" + inertia.name, epsilon, steps);
  const Vector solved = ldl.solve({n[0], n[1], n[2]}, "turn_" + inertia.name, steps);
  return dot(n, {solved[0], solved[1], solved[2]});
}

bool has_compulsion(const Dynamics& dynamics) {
  const Vector spread = forces_without_body(dynamics);
  const bool has_spread = std::any_of(spread.begin(), spread.end(), [](Expr e) { return !e.is_zero(); });
  return !has_spread || spreading_coordinates(dynamics);
}

std::optional<Compulsion> compulsion(const Dynamics& dynamics, const Vector& candidate, Expr epsilon, Steps& steps) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  ir::Graph& graph = kinematics.field[0].graph();
  const Vector spread = forces_without_body(dynamics);
  const bool has_spread = std::any_of(spread.begin(), spread.end(), [](Expr e) { return !e.is_zero(); });
  Vector z(spread.size(), Expr(graph, graph.constant(0)));
  Expr singular(graph, graph.constant(0));
  if (has_spread) {
    const auto coordinates = spreading_coordinates(dynamics);
    if (!coordinates) return std::nullopt;
    const Metric metric(dynamics, *coordinates, epsilon, steps);
    steps.begin("generalized forces, raised: G z = Q");
    z = metric.solve(spread, "z", steps);
    singular = metric.is_singular();
  }
  Expr twice(graph, graph.constant(0));
  for (const BodyMotion& body : *kinematics.bodies) {
    steps.begin("deviation of " + body.name +
                " from free motion, m a - F and d(I omega)/dt - M (theory.md, section 6)");
    const BodyAcceleration a = acceleration_of(body, dynamics, candidate);
    const Vector3 free_force = body.force + body.mass * combination(body.J, z);
    const Vector3 deviation = steps.name(body.mass * a.linear - free_force, "deviation_" + body.name);
    twice += dot(deviation, deviation) * pow(body.mass, -1);
    if (!body.is_rigid) continue;
    const Vector3& omega = body.rotation.omega;
    Vector3 torque = body.inertia_times(a.angular) - body.inertia_times(combination(body.W, z));
    torque = torque - along_axes_of_omega(body, body.moment);
    if (!body.is_isotropic) torque = torque + cross(omega, body.inertia_times(omega));
    torque = steps.name(torque, "torque_" + body.name);
    twice += square_in_inverse_inertia({body.inertia, body.is_isotropic, body.name}, torque, epsilon, steps);
  }
  return Compulsion{support::Rational(1) / 2 * twice, singular};
}

}  // namespace gaussgen::strategy
