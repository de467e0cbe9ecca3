#include "gauss/oracle/bare_body.hpp"

namespace gaussgen::oracle {

namespace {

Vec3 multiply(const Mat3& m, const Vec3& v) {
  Vec3 result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

Mat3 multiply(const Mat3& a, const Mat3& b) {
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  }
  return result;
}

Mat3 about(char axis, const Real& angle) {
  const Real c = cos(angle), s = sin(angle);
  if (axis == 'x') return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
  if (axis == 'y') return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

}  // namespace

Body triaxial_body(const Real& mass, const Vec3& p) {
  Body body{Vec(6, mass / 6), {}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (const int sign : {1, -1}) {
      Vec3 point{0, 0, 0};
      point[i] = sign * p[i];
      body.points.push_back(point);
    }
  }
  return body;
}

Body isotropic_body(const Real& mass, const Real& inertia) {
  const Real p = sqrt(3 * inertia / (2 * mass));
  return triaxial_body(mass, {p, p, p});
}

Body turned(Body body, const Mat3& R) {
  for (Vec3& point : body.points) point = multiply(R, point);
  return body;
}

std::vector<Vec3> placed(const Body& body, const Vec3& centre, const Mat3& attitude) {
  std::vector<Vec3> result;
  for (const Vec3& point : body.points) {
    const Vec3 arm = multiply(attitude, point);
    result.push_back({centre[0] + arm[0], centre[1] + arm[1], centre[2] + arm[2]});
  }
  return result;
}

Mat3 euler_matrix(const std::string& sequence, const Vec3& angles) {
  return multiply(multiply(about(sequence[0], angles[0]), about(sequence[1], angles[1])),
                  about(sequence[2], angles[2]));
}

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Mat3 matrix(const Quaternion& e) {
  Mat3 result;
  const Quaternion conjugate{e[0], -e[1], -e[2], -e[3]};
  for (std::size_t j = 0; j < 3; ++j) {
    Quaternion unit{0, 0, 0, 0};
    unit[j + 1] = 1;
    const Quaternion image = product(product(e, unit), conjugate);
    for (std::size_t i = 0; i < 3; ++i) result[i][j] = image[i + 1];
  }
  return result;
}

Quaternion exponential(const Vec3& theta) {
  const Real angle = sqrt(theta[0] * theta[0] + theta[1] * theta[1] + theta[2] * theta[2]);
  // Near 0 the quotient is its series: the steps of the difference quotients are 1e-12.
  const Real square = angle * angle;
  const Real factor =
      angle < Real("1e-8") ? Real(Real(1) / 2 - square / 48 + square * square / 3840) : Real(sin(angle / 2) / angle);
  return {cos(angle / 2), factor * theta[0], factor * theta[1], factor * theta[2]};
}

Vec3 angular_velocity(const Vec3& theta, const Vec3& theta_dot, const Quaternion& e, bool in_space) {
  const Real h("1e-12");
  const auto at = [&](const Real& tau) {
    const Quaternion delta =
        exponential({theta[0] + tau * theta_dot[0], theta[1] + tau * theta_dot[1], theta[2] + tau * theta_dot[2]});
    return in_space ? product(delta, e) : product(e, delta);
  };
  const Quaternion now = at(0), ahead = at(h), behind = at(-h);
  Quaternion rate;
  for (std::size_t i = 0; i < 4; ++i) rate[i] = (ahead[i] - behind[i]) / h;  // twice the rate
  const Quaternion conjugate{now[0], -now[1], -now[2], -now[3]};
  const Quaternion omega = in_space ? product(rate, conjugate) : product(conjugate, rate);
  return {omega[1], omega[2], omega[3]};
}

Quaternion quaternion_rate(const Quaternion& e, const Vec3& omega, bool in_space) {
  const Quaternion half{0, omega[0] / 2, omega[1] / 2, omega[2] / 2};
  return in_space ? product(half, e) : product(e, half);
}

}  // namespace gaussgen::oracle
