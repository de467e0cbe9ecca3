// Held coordinates that move, under constraints that are coupled; a body with all six freedoms and products of inertia.

#include "gauss/oracle/bare_body.hpp"
#include "gauss/oracle/bare_case.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "gauss/oracle/skew_top.hpp"

namespace gaussgen::oracle {

namespace {

// Three constraints in which the same three speeds occur, with numbers as coefficients: a safe elimination that is no
// permutation. Each contains a held coordinate that accelerates.
constexpr const char* k_coupled_drives = R"(
gauss: 1
name: coupled_drives
parameters:
  m1: {value: 1.3}
  m2: {value: 0.7}
  m3: {value: 2.1}
  g: {value: 9.81}
  Omega: {value: 1.5}
coordinates:
  q1: {}
  q2: {}
  q3: {}
  q4: {}
  q5: {}
  x1: {held_at: sin(Omega*t)/2}
  x2: {held_at: t^3/5}
particles:
  first: {mass: m1, position: [q1 + x1*q5/2, q2 + q4^2/3, q3 + x2*q4]}
  second: {mass: m2, position: [q4 + q1^2/4, q5 + x2/3, q2 + x1*q5]}
  third: {mass: m3, position: [x1 + q3/2, q5 - x2, q1*q3/3 + q4/2 + x1]}
constraints:
  one: {velocity: 2*dot(q1) + dot(q2) - 3*dot(q3) + sin(q4)*dot(q4) + q5*dot(x1)}
  two: {velocity: 3*dot(q1) - dot(q2) + dot(q3) + q4*dot(q5) + dot(x2)}
  three: {velocity: dot(q1) + 4*dot(q2) + 2*dot(q3) + q5*dot(q4) - dot(x1)/2 + q4*dot(x2)}
forces:
  gravity: {uniform: [0, 0, -g]}
  drag: {generalized: {q2: -dot(q2)/3, x1: q4}}
)";

// A body with all its freedoms as coordinates, one of them held and moving, so that every reaction is a wrench of its own.
std::string released_top_text() {
  return R"(
gauss: 1
name: released_top
parameters:)" +
         skew_top::k_parameters + R"(
  g: {value: 9.81}
  l: {value: 0.7}
coordinates:
  y: {}
  z: {}
  x: {held_at: l*t^2}
)" + skew_top::orientations("body") +
         R"(
bodies:
  top:
    mass: m)" +
         skew_top::k_inertia +
         R"(
    position: [x, y + x*z/4, z - y^2/5]
    orientation: attitude
constraints:
  edge: {velocity: dot(y) + l*wx*e0 - z*wz/2 + y*dot(x), point: [x - l, y, z + l/3]}
  blade: {velocity: wy + wz/3 - e1*dot(z) - t*dot(x)}
forces:
  gravity: {uniform: [0, 0, -g]}
)";
}

}  // namespace

Case coupled_drives(unsigned seed) {
  Case c = start(model_of_text(k_coupled_drives), seed, {"q1", "q2", "q3", "q4", "q5"});
  const Values v = c.values;
  hold(c.bare, [Omega = v.at("Omega")](const Real& t) -> Real { return sin(Omega * t) / 2; });
  hold(c.bare, [](const Real& t) -> Real { return t * t * t / 5; });
  c.bare.field = {0, 0, -v.at("g")};
  c.bare.mass = {v.at("m1"), v.at("m2"), v.at("m3")};
  c.bare.positions = [](const Vec& y, const Real&) {
    const Real q1 = y[0], q2 = y[1], q3 = y[2], q4 = y[3], q5 = y[4], x1 = y[5], x2 = y[6];
    return std::vector<Vec3>{{q1 + x1 * q5 / 2, q2 + q4 * q4 / 3, q3 + x2 * q4},
                             {q4 + q1 * q1 / 4, q5 + x2 / 3, q2 + x1 * q5},
                             {x1 + q3 / 2, q5 - x2, q1 * q3 / 3 + q4 / 2 + x1}};
  };
  c.bare.generalized = {0, -v.at("q2_dot") / 3, 0, 0, 0, v.at("q4"), 0};
  c.bare.constraints = [](const Vec& y, const Vec& u, const Real&) -> Vec {
    return {2 * u[0] + u[1] - 3 * u[2] + sin(y[3]) * u[3] + y[4] * u[5], 3 * u[0] - u[1] + u[2] + y[3] * u[4] + u[6],
            u[0] + 4 * u[1] + 2 * u[2] + y[4] * u[3] - u[5] / 2 + y[3] * u[6]};
  };
  return c;
}

Case released_top(unsigned seed) {
  Case c = start(model_of_text(released_top_text()), seed, {"y", "z", "wx", "wy", "wz"});
  const Values v = c.values;
  const Real l = v.at("l");
  hold(c.bare, [=](const Real& t) -> Real { return l * t * t; });
  c.bare.field = {0, 0, -v.at("g")};
  const Body body = skew_top::body(v);
  c.bare.mass = body.mass;
  const Quaternion e_0 = skew_top::attitude(v);
  c.bare.positions = [=](const Vec& y, const Real&) {
    const Vec3 centre{y[5], y[0] + y[5] * y[1] / 4, y[1] - y[0] * y[0] / 5};
    return placed(body, centre, matrix(product(e_0, exponential({y[2], y[3], y[4]}))));
  };
  c.bare.constraints = [=](const Vec& y, const Vec& u, const Real& t) -> Vec {
    const Vec3 theta{y[2], y[3], y[4]};
    const Quaternion e = product(e_0, exponential(theta));
    const Vec3 omega = angular_velocity(theta, {u[2], u[3], u[4]}, e_0, false);
    return {u[0] + l * omega[0] * e[0] - y[1] * omega[2] / 2 + y[0] * u[5],
            omega[1] + omega[2] / 3 - e[1] * u[1] - t * u[5]};
  };
  return c;
}

}  // namespace gaussgen::oracle
