// Models that are written here only: more of what can go wrong meets in them than in those of models/.

#include "gauss/oracle/bare_body.hpp"
#include "gauss/oracle/bare_case.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "gauss/oracle/skew_top.hpp"

namespace gaussgen::oracle {

namespace {

// Triaxial body, Euler angles of another sequence, one of them driven in time as well; a nonlinear constraint in time.
constexpr const char* k_driven_gyroscope = R"(
gauss: 1
name: driven_gyroscope
parameters:
  m: {value: 2}
  g: {value: 9.81}
  p1: {value: 0.3}
  p2: {value: 0.4}
  p3: {value: 0.5}
  l: {value: 0.7}
  Omega: {value: 1.5}
inputs:
  torque: {value: 0}
coordinates:
  a: {}
  b: {}
  c: {}
  z: {}
  x: {held_at: l + sin(Omega*t)/3}
bodies:
  gyroscope:
    mass: m
    inertia: [m/3*(p2^2 + p3^2), m/3*(p3^2 + p1^2), m/3*(p1^2 + p2^2)]
    position: [x*sin(b) + t^2*a/5, x*cos(b)*sin(a), z + x*cos(a)]
    orientation: {euler: xyz, angles: [a + Omega*t^2, b - x/4, c]}
constraints:
  speed: {velocity: dot(a)^2 + dot(z)*dot(c) + z*dot(x) - Omega*t}
forces:
  gravity: {uniform: [0, g/3, -g]}
  drive: {generalized: {c: torque*cos(a), x: torque, z: -dot(z)/2}}
)";

// Triaxial body with products of inertia (axes turned by 0.6, 0.8), a point of it on a moving support.
std::string free_body_text(bool in_space) {
  return R"(
gauss: 1
name: free_body
parameters:)" +
         skew_top::k_parameters + R"(
  g: {value: 9.81}
  l: {value: 0.7}
inputs:
  torque: {value: 0}
coordinates:
  s: {}
  x: {held_at: l*t^2}
)" + skew_top::orientations(in_space ? "space" : "body") +
         R"(
bodies:
  top:
    mass: m)" +
         skew_top::k_inertia +
         R"(
    position: [x + 2*l*(e1*e3 + e0*e2), s + 2*l*(e2*e3 - e0*e1), l*(e0^2 - e1^2 - e2^2 + e3^2)]
    orientation: attitude
constraints:
  edge: {velocity: wx*e1 + dot(s)*e0 - dot(e2*x) + wz*wy*t}
forces:
  gravity: {uniform: [0, 0, -g]}
  magnet: {potential: m*g*l*e1*e3}
  motor: {generalized: {wy: torque - wx/2}}
)";
}

}  // namespace

Case driven_gyroscope(unsigned seed) {
  Case c = start(model_of_text(k_driven_gyroscope), seed, {"a", "b", "c", "z"});
  const Values v = c.values;
  const Real m = v.at("m"), l = v.at("l"), Omega = v.at("Omega"), torque = v.at("torque");
  hold(c.bare, [=](const Real& t) -> Real { return l + sin(Omega * t) / 3; });
  c.bare.field = {0, v.at("g") / 3, -v.at("g")};
  const Body body = triaxial_body(m, {v.at("p1"), v.at("p2"), v.at("p3")});
  c.bare.mass = body.mass;
  c.bare.positions = [=](const Vec& y, const Real& t) {
    const Real a = y[0], b = y[1], z = y[3], x = y[4];
    const Vec3 centre{x * sin(b) + t * t * a / 5, x * cos(b) * sin(a), z + x * cos(a)};
    return placed(body, centre, euler_matrix("xyz", {a + Omega * t * t, b - x / 4, y[2]}));
  };
  c.bare.generalized = {0, 0, torque * cos(v.at("a")), -v.at("z_dot") / 2, torque};
  c.bare.constraints = [=](const Vec& y, const Vec& u, const Real& t) -> Vec {
    return {u[0] * u[0] + u[3] * u[2] + y[3] * u[4] - Omega * t};
  };
  return c;
}

Case free_body(unsigned seed, bool in_space) {
  Case c = start(model_of_text(free_body_text(in_space)), seed, {"s", "wx", "wy", "wz"});
  const Values v = c.values;
  const Real m = v.at("m"), l = v.at("l"), g = v.at("g");
  hold(c.bare, [=](const Real& t) -> Real { return l * t * t; });
  c.bare.field = {0, 0, -g};
  const Body body = skew_top::body(v);
  c.bare.mass = body.mass;
  const Quaternion e_0 = skew_top::attitude(v);
  const auto attitude = [=](const Vec3& theta) {
    return in_space ? product(exponential(theta), e_0) : product(e_0, exponential(theta));
  };
  c.bare.positions = [=](const Vec& y, const Real&) {
    const Quaternion e = attitude({y[1], y[2], y[3]});
    const Vec3 centre{y[4] + 2 * l * (e[1] * e[3] + e[0] * e[2]), y[0] + 2 * l * (e[2] * e[3] - e[0] * e[1]),
                      l * (e[0] * e[0] - e[1] * e[1] - e[2] * e[2] + e[3] * e[3])};
    return placed(body, centre, matrix(e));
  };
  c.bare.potential = [=](const Vec& y, const Real&) -> Real {
    const Quaternion e = attitude({y[1], y[2], y[3]});
    return m * g * l * e[1] * e[3];
  };
  c.bare.generalized = {0, 0, v.at("torque") - v.at("wx") / 2, 0, 0};
  c.bare.constraints = [=](const Vec& y, const Vec& u, const Real& t) -> Vec {
    const Vec3 theta{y[1], y[2], y[3]};
    const Vec3 rate{u[1], u[2], u[3]};
    const Quaternion e = attitude(theta);
    const Vec3 omega = angular_velocity(theta, rate, e_0, in_space);
    const Real e2_rate = quaternion_rate(e, omega, in_space)[2];
    return {omega[0] * e[1] + u[0] * e[0] - (e2_rate * y[4] + e[2] * u[4]) + omega[2] * omega[1] * t};
  };
  return c;
}

}  // namespace gaussgen::oracle
