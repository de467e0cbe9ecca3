#include "gauss/oracle/bare_models.hpp"

#include "catch_shim.hpp"
#include "gauss/oracle/bare_body.hpp"
#include "gauss/oracle/bare_case.hpp"
#include "gauss/oracle/evaluation.hpp"

namespace gaussgen::oracle {

namespace {

Case sphere(unsigned seed) {
  Case c = start(model_of_file("sphere_in_cylinder"), seed, {"chi", "zeta", "phi", "psi", "theta"});
  const Values v = c.values;
  const Real r = v.at("r"), R = v.at("R"), m = v.at("m");
  hold(c.bare, [=](const Real&) { return R - r; });
  c.bare.field = {0, 0, -v.at("g")};
  const Body ball = isotropic_body(m, v.at("J"));
  c.bare.mass = ball.mass;
  c.bare.positions = [=](const Vec& y, const Real&) {
    const Vec3 centre{y[5] * cos(y[0]), y[5] * sin(y[0]), y[1]};
    return placed(ball, centre, euler_matrix("zxz", {y[3], y[4], y[2]}));
  };
  c.bare.constraints = [=](const Vec& y, const Vec& u, const Real&) -> Vec {
    return {(R - r) * u[0] + r * u[3] + r * u[2] * cos(y[4]),
            u[1] - r * u[4] * sin(y[3] - y[0]) + r * u[2] * sin(y[4]) * cos(y[3] - y[0])};
  };
  return c;
}

Case sphere_quaternion(unsigned seed) {
  Case c = start(model_of_file("sphere_in_cylinder_quaternion"), seed, {"chi", "zeta", "wx", "wy", "wz"});
  const Values v = c.values;
  const Real r = v.at("r"), R = v.at("R");
  hold(c.bare, [=](const Real&) { return R - r; });
  c.bare.field = {0, 0, -v.at("g")};
  const Body ball = isotropic_body(v.at("m"), v.at("J"));
  c.bare.mass = ball.mass;
  const Quaternion e{v.at("e0"), v.at("e1"), v.at("e2"), v.at("e3")};
  c.bare.positions = [=](const Vec& y, const Real&) {
    const Vec3 centre{y[5] * cos(y[0]), y[5] * sin(y[0]), y[1]};
    return placed(ball, centre, matrix(product(exponential({y[2], y[3], y[4]}), e)));
  };
  c.bare.constraints = [=](const Vec& y, const Vec& u, const Real&) -> Vec {
    const Vec3 omega = angular_velocity({y[2], y[3], y[4]}, {u[2], u[3], u[4]}, e, true);
    return {(R - r) * u[0] + r * omega[2], u[1] + r * (omega[0] * sin(y[0]) - omega[1] * cos(y[0]))};
  };
  return c;
}

Case skew_chart(unsigned seed) {
  Case c = start(model_of_file("skew_chart"), seed, {"a", "b", "c", "d", "e"});
  const Values v = c.values;
  hold(c.bare, [=](const Real& t) -> Real { return 1 + v.at("amplitude") * sin(v.at("frequency") * t); });
  c.bare.field = {0, 0, -v.at("g")};
  c.bare.mass = {v.at("m1"), v.at("m2")};
  c.bare.positions = [](const Vec& y, const Real&) {
    const Real a = y[0], b = y[1], cc = y[2], d = y[3], e = y[4], s = y[5];
    return std::vector<Vec3>{{s + a / 2, b + s * a / 3, cc - s * s / 4},
                             {d + s / 3, e - a * s / 2 + d * d / 5, a + s + e / 2}};
  };
  c.bare.potential = [k = v.at("k")](const Vec& y, const Real&) -> Real {
    return k / 2 * (pow(y[5] - y[3], 2) + pow(y[0] - y[4], 2));
  };
  return c;
}

Case skew_nonholonomic(unsigned seed) {
  Case c = start(model_of_file("skew_nonholonomic"), seed, {"q1", "q2", "q3"});
  hold(c.bare, [](const Real&) { return Real("0.4"); });
  hold(c.bare, [](const Real&) { return Real("-0.2"); });
  c.bare.field = {0, 0, -c.values.at("g")};
  c.bare.mass = {c.values.at("m1"), c.values.at("m2")};
  c.bare.positions = [](const Vec& y, const Real&) {
    const Real q1 = y[0], q2 = y[1], q3 = y[2], x1 = y[3], x2 = y[4];
    return std::vector<Vec3>{{q1 + x1 / 2, q2 + x1 * q1 / 3 + x2, q3 - x2 * q2 / 4},
                             {q3 + x2 / 3 + q1 / 5, q2 - q1 * x2 / 2 + x1, q1 + x1 + q2 / 2}};
  };
  c.bare.constraints = [](const Vec& y, const Vec& u, const Real&) -> Vec {
    return {(1 + y[0] * y[0]) * u[2] + y[1] * u[0] - u[1] + y[4] * u[3] + Real("0.7") * u[4]};
  };
  return c;
}

}  // namespace

std::vector<BareModel> bare_models() {
  return {{"sphere_in_cylinder", sphere},
          {"sphere_in_cylinder_quaternion", sphere_quaternion},
          {"skew_chart", skew_chart},
          {"skew_nonholonomic", skew_nonholonomic},
          {"driven_gyroscope", driven_gyroscope},
          {"free_body_in_space", [](unsigned seed) { return free_body(seed, true); }},
          {"free_body_in_body_axes", [](unsigned seed) { return free_body(seed, false); }},
          {"coupled_drives", coupled_drives},
          {"released_top", released_top}};
}

Case case_of(const std::string& name, unsigned seed) {
  for (const BareModel& model : bare_models()) {
    if (model.name == name) return model.at(seed);
  }
  FAIL("no bare model " << name);
  return {};
}

}  // namespace gaussgen::oracle
