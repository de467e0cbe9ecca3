#include "symbolic/quaternion.hpp"

#include "symbolic/rational.hpp"

namespace gaussgen::symbolic {

namespace {

const support::Rational k_half = support::Rational(1) / 2;
const support::Rational k_eighth = support::Rational(1) / 8;

}  // namespace

Quaternion turned(const Quaternion& e, const Vector3& theta, model::Axes frame) {
  const ex delta_0 = 1 - number(k_eighth) * dot(theta, theta);
  const Vector3 delta = number(k_half) * theta;
  const Vector3 v{e[1], e[2], e[3]};
  const Vector3 side = frame == model::Axes::space ? cross(delta, v) : cross(v, delta);
  const Vector3 w = delta_0 * v + e[0] * delta + side;
  return {delta_0 * e[0] - dot(delta, v), w[0], w[1], w[2]};
}

Vector3 angular_velocity(const Vector3& theta, const Vector3& theta_dot, model::Axes frame) {
  const ex factor = number(frame == model::Axes::space ? k_half : support::Rational(-k_half));
  return theta_dot + factor * cross(theta, theta_dot);
}

Matrix3 rotation_matrix(const Quaternion& e) {
  const auto square = [](const ex& a) { return GiNaC::pow(a, 2); };
  return {
      Vector3{1 - 2 * (square(e[2]) + square(e[3])), 2 * (e[1] * e[2] - e[0] * e[3]), 2 * (e[1] * e[3] + e[0] * e[2])},
      Vector3{2 * (e[1] * e[2] + e[0] * e[3]), 1 - 2 * (square(e[1]) + square(e[3])), 2 * (e[2] * e[3] - e[0] * e[1])},
      Vector3{2 * (e[1] * e[3] - e[0] * e[2]), 2 * (e[2] * e[3] + e[0] * e[1]), 1 - 2 * (square(e[1]) + square(e[2]))}};
}

}  // namespace gaussgen::symbolic
