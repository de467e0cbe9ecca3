// One mechanism in several descriptions: the same physical state has the same acceleration of its places and the same forces.
#include <array>
#include <cmath>

#include "catch_shim.hpp"
#include "double_pendulum.hpp"
#include "double_pendulum_planar.hpp"
#include "gauss/simulate/simulation.hpp"
#include "lagrange_top.hpp"
#include "lagrange_top_euler.hpp"
#include "spherical_pendulum.hpp"
#include "spherical_pendulum_angles.hpp"
#include "spherical_pendulum_quaternion.hpp"
#include "turning.hpp"

namespace cartesian = gauss::spherical_pendulum;
namespace angles = gauss::spherical_pendulum_angles;
namespace attitude = gauss::spherical_pendulum_quaternion;
namespace top = gauss::lagrange_top;
namespace euler = gauss::lagrange_top_euler;
namespace joints = gauss::double_pendulum;
namespace places = gauss::double_pendulum_planar;

GAUSS_MODEL(Cartesian, cartesian);
GAUSS_MODEL(Angles, angles);
GAUSS_MODEL(Attitude, attitude);
GAUSS_MODEL(Joints, joints);
GAUSS_MODEL(Places, places);

using physics::about_x;
using physics::about_y;
using physics::about_z;
using physics::Quaternion;
using physics::Vec;

namespace {

/// Descriptions differ in rounding only, times what their equations amplify.
void check_same(const Vec& found, const Vec& expected, double tolerance = 1e-12) {
  double size = 1;
  for (const double x : expected) size = std::max(size, std::abs(x));
  for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(0).margin(tolerance * size));
}

template <class Model, class Inputs, class Prepared, class State>
typename Model::template Derivative<double> rates(const State& state, const Inputs& inputs, const Prepared& prepared) {
  typename Model::template Derivative<double> found;
  REQUIRE(Model::rhs(0.0, state, inputs, prepared, found) == gauss::Status::ok);
  return found;
}

struct Bob {
  Vec place, velocity, acceleration, force;
};

struct Swing {
  double theta, phi, theta_dot, phi_dot;
};

constexpr Swing k_swings[] = {{0.5, 0, 0, 3}, {1.1, 0.7, -2, 0.4}, {2.4, -2, 1.5, -2.5}, {1.57, 3, -4, 1}};

Bob by_angles(const Swing& swing) {
  const auto prepared = prepare(angles::Parameters<double>{});
  const angles::Inputs<double> inputs;
  const angles::State<double> state{{swing.theta, swing.phi, swing.theta_dot, swing.phi_dot}};
  const auto found = rates<Angles>(state, inputs, prepared);
  const double l = angles::Parameters<double>{}.l;
  const double s = std::sin(swing.theta), c = std::cos(swing.theta);
  const double sf = std::sin(swing.phi), cf = std::cos(swing.phi);
  const double a = swing.theta_dot, b = swing.phi_dot;
  // Along growing radius rho = l sin(theta), azimuth and height.
  const double radial = l * (found.theta_ddot() * c - a * a * s - b * b * s);
  const double around = l * (found.phi_ddot() * s + 2 * a * b * c);
  angles::ReactionForces<double> forces;
  REQUIRE(reaction_forces(0.0, state, inputs, prepared, forces) == gauss::Status::ok);
  return {{l * s * cf, l * s * sf, -l * c},
          {l * (a * c * cf - b * s * sf), l * (a * c * sf + b * s * cf), l * a * s},
          {radial * cf - around * sf, radial * sf + around * cf, l * (found.theta_ddot() * s + a * a * c)},
          {forces.r.force_on_bob[0], forces.r.force_on_bob[1], forces.r.force_on_bob[2]}};
}

Bob by_places(const Bob& bob) {
  const auto prepared = prepare(cartesian::Parameters<double>{});
  const cartesian::Inputs<double> inputs;
  cartesian::State<double> state{};
  for (std::size_t i = 0; i < 3; ++i) {
    state.values[i] = bob.place[i];
    state.values[3 + i] = bob.velocity[i];
  }
  const auto found = rates<Cartesian>(state, inputs, prepared);
  cartesian::ReactionForces<double> forces;
  REQUIRE(reaction_forces(0.0, state, inputs, prepared, forces) == gauss::Status::ok);
  const auto& force = forces.string.force_on_bob;
  return {bob.place, bob.velocity, {found.x_ddot(), found.y_ddot(), found.z_ddot()}, {force[0], force[1], force[2]}};
}

/// The string points along -z of its frame; how far it is turned about itself (`turn`) must not matter.
Bob by_quaternion(const Swing& swing, const Bob& bob, double turn) {
  const auto prepared = prepare(attitude::Parameters<double>{});
  const attitude::Inputs<double> inputs;
  const double l = attitude::Parameters<double>{}.l;
  const Quaternion q = about_z(swing.phi) * about_y(-swing.theta) * about_z(turn);
  const Vec w = cross(bob.place, bob.velocity) / (l * l);
  const Vec in_body = q.back(w);
  const attitude::State<double> state{{q.w, q.x, q.y, q.z, in_body[0], in_body[1], in_body[2]}};
  const auto found = rates<Attitude>(state, inputs, prepared);
  // The angular velocity has no part along the string, so w' in space is that of the components in the body turned.
  const Vec turning = q.turned({found.wx_dot(), found.wy_dot(), found.wz_dot()});
  attitude::JointReactions<double> joint;
  REQUIRE(joint_reactions(0.0, state, inputs, prepared, joint) == gauss::Status::ok);
  check_same({joint.pivot.moment[0], joint.pivot.moment[1], joint.pivot.moment[2]}, {});
  return {q.turned({0, 0, -l}),
          cross(w, bob.place),
          cross(turning, bob.place) + cross(w, cross(w, bob.place)),
          {joint.pivot.force[0], joint.pivot.force[1], joint.pivot.force[2]}};
}

void check_bob(const Bob& found, const Bob& expected) {
  check_same(found.place, expected.place);
  check_same(found.velocity, expected.velocity);
  check_same(found.acceleration, expected.acceleration);
  check_same(found.force, expected.force);
}

}  // namespace

TEST_CASE(
    "a spherical pendulum by angles, by places and by quaternion has one acceleration and one force in its string") {
  for (const Swing& swing : k_swings) {
    INFO("theta = " << swing.theta);
    const Bob expected = by_angles(swing);
    check_bob(by_places(expected), expected);
    check_bob(by_quaternion(swing, expected, 0), expected);
    check_bob(by_quaternion(swing, expected, 1.9), expected);
  }
}

TEST_CASE("a spherical pendulum by angles, by places and by quaternion swings through the same places") {
  angles::State<double> a;
  cartesian::State<double> c;
  attitude::State<double> q;
  const auto prepared_a = prepare(angles::Parameters<double>{});
  const auto prepared_c = prepare(cartesian::Parameters<double>{});
  const auto prepared_q = prepare(attitude::Parameters<double>{});
  REQUIRE(initial_state(prepared_a, a) == gauss::Status::ok);
  REQUIRE(initial_state(prepared_c, c) == gauss::Status::ok);
  REQUIRE(initial_state(prepared_q, q) == gauss::Status::ok);
  const auto model_a = gauss::integrate::bind_model<Angles>(prepared_a, angles::Inputs<double>{});
  const auto model_c = gauss::integrate::bind_model<Cartesian>(prepared_c, cartesian::Inputs<double>{});
  const auto model_q = gauss::integrate::bind_model<Attitude>(prepared_q, attitude::Inputs<double>{});
  gauss::simulate::Simulation of_angles(model_a, a);
  gauss::simulate::Simulation of_places(model_c, c);
  gauss::simulate::Simulation of_quaternion(model_q, q);
  const double l = angles::Parameters<double>{}.l;
  for (const double t : {0.5, 1.0, 3.0}) {
    REQUIRE(of_angles.advance_to(t));
    REQUIRE(of_places.advance_to(t));
    REQUIRE(of_quaternion.advance_to(t));
    a = of_angles.state();
    c = of_places.state();
    q = of_quaternion.state();
    const Vec expected{l * std::sin(a.theta()) * std::cos(a.phi()), l * std::sin(a.theta()) * std::sin(a.phi()),
                       -l * std::cos(a.theta())};
    check_same({c.x(), c.y(), c.z()}, expected, 1e-10);
    check_same(Quaternion{q.e0(), q.e1(), q.e2(), q.e3()}.turned({0, 0, -l}), expected, 1e-10);
  }
}

TEST_CASE("Lagrange's top by Euler's angles and by quaternion turns alike, with one force in its fixed point") {
  const auto prepared = prepare(top::Parameters<double>{});
  const auto prepared_euler = prepare(euler::Parameters<double>{});
  for (const auto& angle : {Vec{0.3, 0.6, 1}, Vec{-2, 1.4, 0.2}, Vec{1, 2.8, -3}}) {
    const Vec rate{1.7, -2.2, 140};
    euler::State<double> by_euler{{angle[0], angle[1], angle[2], rate[0], rate[1], rate[2]}};
    euler::Derivative<double> d;
    REQUIRE(rhs(0.0, by_euler, euler::Inputs<double>{}, prepared_euler, d) == gauss::Status::ok);
    euler::Reactions<double> held;
    REQUIRE(reactions(0.0, by_euler, euler::Inputs<double>{}, prepared_euler, held) == gauss::Status::ok);

    const double st = std::sin(angle[1]), ct = std::cos(angle[1]), sf = std::sin(angle[2]), cf = std::cos(angle[2]);
    // omega = psi' (st sf, st cf, ct) + theta' (cf, -sf, 0) + phi' e3, and its derivative.
    const Vec w{rate[0] * st * sf + rate[1] * cf, rate[0] * st * cf - rate[1] * sf, rate[0] * ct + rate[2]};
    const Vec expected{d.psi_ddot() * st * sf + rate[0] * (ct * sf * rate[1] + st * cf * rate[2]) +
                           d.theta_ddot() * cf - rate[1] * sf * rate[2],
                       d.psi_ddot() * st * cf + rate[0] * (ct * cf * rate[1] - st * sf * rate[2]) -
                           d.theta_ddot() * sf - rate[1] * cf * rate[2],
                       d.psi_ddot() * ct - rate[0] * st * rate[1] + d.phi_ddot()};
    const Quaternion q = about_z(angle[0]) * about_x(angle[1]) * about_z(angle[2]);
    const top::State<double> state{{q.w, q.x, q.y, q.z, w[0], w[1], w[2]}};
    top::Derivative<double> found;
    REQUIRE(rhs(0.0, state, top::Inputs<double>{}, prepared, found) == gauss::Status::ok);
    check_same({found.w1_dot(), found.w2_dot(), found.w3_dot()}, expected);
    top::JointReactions<double> joint;
    REQUIRE(joint_reactions(0.0, state, top::Inputs<double>{}, prepared, joint) == gauss::Status::ok);
    check_same({joint.pivot.force[0], joint.pivot.force[1], joint.pivot.force[2]},
               {held.px.generalized, held.py.generalized, held.pz.generalized});
  }
}

TEST_CASE("a double pendulum by joints and by places has one acceleration and the same forces in pivot and elbow") {
  const auto prepared = prepare(joints::Parameters<double>{});
  const auto prepared_places = prepare(places::Parameters<double>{});
  const double l1 = joints::Parameters<double>{}.l1;
  for (const auto& s : {std::array<double, 4>{1.5, 0, 0, 0}, {0.4, -1, 3, -2}, {-2.5, 2, -4, 6}}) {
    const joints::State<double> state{{s[0], s[1], s[2], s[3]}};
    const auto found = rates<Joints>(state, joints::Inputs<double>{}, prepared);
    joints::JointReactions<double> joint;
    REQUIRE(joint_reactions(0.0, state, joints::Inputs<double>{}, prepared, joint) == gauss::Status::ok);

    const double sine = std::sin(s[0]), cosine = std::cos(s[0]);
    const places::State<double> apart{{0, 0, s[0], l1 * sine, -l1 * cosine, s[0] + s[1],  //
                                       0, 0, s[2], l1 * cosine * s[2], l1 * sine * s[2], s[2] + s[3]}};
    const auto other = rates<Places>(apart, places::Inputs<double>{}, prepared_places);
    check_same({other.angle1_ddot(), other.angle2_ddot(), 0},
               {found.pivot_ddot(), found.pivot_ddot() + found.elbow_ddot(), 0});
    places::ReactionForces<double> forces;
    REQUIRE(reaction_forces(0.0, apart, places::Inputs<double>{}, prepared_places, forces) == gauss::Status::ok);
    check_same({forces.pivot_x.force_on_top[0], forces.pivot_y.force_on_top[1], 0},
               {joint.pivot.force[0], joint.pivot.force[1], joint.pivot.force[2]});
    check_same({forces.elbow_x.force_on_start[0], forces.elbow_y.force_on_start[1], 0},
               {joint.elbow.force[0], joint.elbow.force[1], joint.elbow.force[2]});
  }
}
