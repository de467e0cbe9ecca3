#include "kinematics/covariant.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "ir/contract.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Vector3;

namespace {

// I η + ω × I ω: the gyroscopic part vanishes for an isotropic tensor, so it is not even formed.
Vector3 angular_drift(const BodyMotion& body) {
  const Vector3 direct = body.inertia_times(body.eta);
  if (body.is_isotropic) return direct;
  const Vector3& omega = body.rotation.omega;
  return direct + cross(omega, body.inertia_times(omega));
}

using Bodies = std::vector<BodyIndex>;

/// The bodies that each coordinate moves: of many coordinates, most move few of many bodies.
support::Indexed<FullIndex, Bodies> moved_bodies(const Kinematics& kinematics) {
  support::Indexed<FullIndex, Bodies> moved(kinematics.symbols.full_count(), Bodies());
  for (const BodyIndex b : kinematics.bodies->indices()) {
    const BodyMotion& body = (*kinematics.bodies)[b];
    for (const FullIndex i : moved.indices()) {
      if (!is_zero(body.J[i]) || (body.is_rigid && !is_zero(body.W[i]))) moved[i].push_back(b);
    }
  }
  return moved;
}

/// Of those that both coordinates move, in the order of the model.
Bodies both(const Bodies& a, const Bodies& b) {
  Bodies common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common;
}

Expr metric_entry(const Kinematics& kinematics, const Bodies& moved, FullIndex i, FullIndex j, Expr zero) {
  Expr sum = zero;
  for (const BodyIndex b : moved) {
    const BodyMotion& body = (*kinematics.bodies)[b];
    sum += body.mass * dot(body.J[i], body.J[j]);
    if (body.is_rigid) sum += dot(body.W[i], body.inertia_times(body.W[j]));
  }
  return sum;
}

Expr bias_entry(const Kinematics& kinematics, const Bodies& moved, FullIndex i, Expr zero) {
  Expr sum = zero;
  for (const BodyIndex b : moved) {
    const BodyMotion& body = (*kinematics.bodies)[b];
    sum += body.mass * dot(body.J[i], body.h);
    if (body.is_rigid) sum += dot(body.W[i], angular_drift(body));
  }
  return sum;
}

Expr kinetic_energy(const Kinematics& kinematics, Expr zero) {
  Expr twice = zero;
  for (const BodyMotion& body : *kinematics.bodies) {
    twice += body.mass * dot(body.velocity, body.velocity);
    const Vector3& omega = body.rotation.omega;
    if (body.is_rigid) twice += dot(omega, body.inertia_times(omega));
  }
  return support::Rational(1) / 2 * twice;
}

}  // namespace

Covariant build_covariant(const Kinematics& kinematics, ir::Graph& graph) {
  const Symbols& symbols = kinematics.symbols;
  const Expr zero(graph, graph.constant(0));
  const std::size_t count = symbols.full_count();
  Covariant result{FullMatrix(count, support::Indexed<FullIndex, Expr>(count, zero)), {}, {}, zero};
  const auto moved = moved_bodies(kinematics);
  for (const FullIndex i : support::indices<FullIndex>(count)) {
    const std::string& label = symbols.label(i);
    for (const FullIndex j : support::indices<FullIndex>(i.value + 1)) {
      const Expr entry =
          metric_entry(kinematics, both(moved[i], moved[j]), i, j, zero).named("G_" + symbols.label(j) + "_" + label);
      result.G[i][j] = entry;
      result.G[j][i] = entry;
    }
    result.bias.push_back(bias_entry(kinematics, moved[i], i, zero).named("bias_" + label));
    result.Q.push_back(
        (kinematics.body_force[i] + (*kinematics.field_force)[i] + kinematics.other_force[i]).named("Q_" + label));
  }
  result.kinetic_energy = kinetic_energy(kinematics, zero);
  return result;
}

}  // namespace gaussgen::kinematics
