// Linkages, with the forces in all their joints.
#include "atwood.hpp"
#include "catch_shim.hpp"
#include "double_pendulum.hpp"
#include "double_pendulum_points.hpp"
#include "follow.hpp"
#include "four_bar.hpp"

using physics::close_to;
using reference::number;

namespace bar4 = gauss::four_bar;
namespace rods = gauss::double_pendulum;
namespace points = gauss::double_pendulum_points;

GAUSS_MODEL(FourBar, bar4);
GAUSS_MODEL(Rods, rods);
GAUSS_MODEL(Points, points);

namespace {

/// Forces reach some hundred newtons, and accelerations amplify what is left of the motion.
constexpr double k_force = 1e3;

template <class Found>
void check_in_plane(const Found& found, const reference::Json& expected, double sense = 1) {
  for (std::size_t i = 0; i < 2; ++i) CHECK(sense * found[i] == close_to(expected[i], k_force));
  CHECK(found[2] == Approx(0).margin(1e-12));
}

/// Where the end of the lower rod is, and how fast, from the angles of both rods against the vertical.
void check_tip(double t, const rods::State<double>& state, const rods::Prepared<double>& prepared, double l1, double l2) {
  const double a = state.pivot(), b = a + state.elbow();
  const double a_dot = state.pivot_dot(), b_dot = a_dot + state.elbow_dot();
  rods::Quantities<double> found;
  REQUIRE(quantities(t, state, {}, prepared, found) == gauss::Status::ok);
  CHECK(found.tip[0] == Approx(l1 * std::sin(a) + l2 * std::sin(b)).margin(1e-14));
  CHECK(found.tip[1] == Approx(-l1 * std::cos(a) - l2 * std::cos(b)).margin(1e-14));
  CHECK(found.tip[2] == 0);
  CHECK(found.reach == Approx(std::sqrt(l1 * l1 + l2 * l2 + 2 * l1 * l2 * std::cos(a - b))));
  const double square = l1 * l1 * a_dot * a_dot + l2 * l2 * b_dot * b_dot + 2 * l1 * l2 * a_dot * b_dot * std::cos(a - b);
  CHECK(found.speed == Approx(std::sqrt(square)).margin(1e-12));
}

}  // namespace

TEST_CASE("a four-bar linkage moves and transmits the forces of the reference in all four joints") {
  const auto file = reference::read("four_bar_reactions");
  bar4::Parameters<double> parameters;
  parameters.L1 = number(file["params"]["L"][0]);
  parameters.L2 = number(file["params"]["L"][1]);
  parameters.L3 = number(file["params"]["L"][2]);
  parameters.L4 = number(file["params"]["L"][3]);
  parameters.m1 = number(file["params"]["m"][0]);
  parameters.m2 = number(file["params"]["m"][1]);
  parameters.m3 = number(file["params"]["m"][2]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  bar4::Inputs<double> inputs;
  inputs.torque = number(file["params"]["torque_on_crank"]);

  bar4::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  REQUIRE(start.alpha() == number(file["initial"]["crank"]));
  REQUIRE(start.alpha_dot() == number(file["initial"]["crank_rate"]));

  physics::follow<FourBar>(file["expected"]["samples"], prepared, inputs, start,
                           [&](const auto& sample, double t, const auto& state) {
                             CHECK(state.alpha() == close_to(sample["crank"], 10));
                             CHECK(state.alpha_dot() == close_to(sample["crank_rate"], 100));
                             CHECK(state.alpha() + state.beta() == close_to(sample["coupler"], 10));
                             CHECK(state.gamma() == close_to(sample["rocker"], 10));
                             bar4::JointReactions<double> joints;
                             REQUIRE(joint_reactions(t, state, inputs, prepared, joints) == gauss::Status::ok);
                             check_in_plane(joints.O.force, sample["F_O_on_crank"]);
                             check_in_plane(joints.A.force, sample["F_A_on_coupler"]);
                             check_in_plane(joints.C.force, sample["F_C_on_rocker"]);
                             bar4::ReactionForces<double> forces;
                             REQUIRE(reaction_forces(t, state, inputs, prepared, forces) == gauss::Status::ok);
                             std::array<double, 3> on_coupler{};
                             for (std::size_t i = 0; i < 3; ++i)
                               on_coupler[i] = forces.loop_x.force_on_B[i] + forces.loop_y.force_on_B[i];
                             check_in_plane(on_coupler, sample["F_B_on_coupler"]);
                             // Pins without friction transmit no moment.
                             for (const auto* moment : {&joints.O.moment, &joints.A.moment, &joints.C.moment}) {
                               CHECK((*moment)[2] == Approx(0).margin(1e-8));
                             }
                           });
}

TEST_CASE("a double pendulum of rods swings as the reference says, with the forces in pivot and elbow") {
  const auto file = reference::read("double_pendulum_rods");
  rods::Parameters<double> parameters;
  parameters.m1 = number(file["params"]["m1"]);
  parameters.m2 = number(file["params"]["m2"]);
  parameters.l1 = number(file["params"]["l1"]);
  parameters.l2 = number(file["params"]["l2"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const rods::Inputs<double> inputs;
  rods::State<double> start;
  initial_state(prepared, start);
  REQUIRE(start.pivot() == Approx(std::acos(0.0)));
  REQUIRE(start.elbow() == 0);

  physics::follow<Rods>(file["expected"]["samples"], prepared, inputs, start,
                        [&](const auto& sample, double t, const auto& state) {
                          CHECK(state.pivot() == close_to(sample["theta"][0], 10));
                          CHECK(state.pivot() + state.elbow() == close_to(sample["theta"][1], 10));
                          CHECK(state.pivot_dot() == close_to(sample["rates"][0], 100));
                          CHECK(state.pivot_dot() + state.elbow_dot() == close_to(sample["rates"][1], 100));
                          rods::JointReactions<double> joints;
                          REQUIRE(joint_reactions(t, state, inputs, prepared, joints) == gauss::Status::ok);
                          check_in_plane(joints.pivot.force, sample["pivot_force_xy"]);
                          check_in_plane(joints.elbow.force, sample["elbow_force_on_rod2_xy"]);
                          check_tip(t, state, prepared, number(file["params"]["l1"]), number(file["params"]["l2"]));
                          CHECK(joints.pivot.moment[2] == Approx(0).margin(1e-12));
                          CHECK(joints.elbow.moment[2] == Approx(0).margin(1e-12));
                        });
}

TEST_CASE("the held lengths of a double pendulum of particles give the forces in its rods") {
  const auto file = reference::read("double_pendulum_points");
  points::Parameters<double> parameters;
  parameters.m1 = number(file["params"]["m1"]);
  parameters.m2 = number(file["params"]["m2"]);
  parameters.l1 = number(file["params"]["l1"]);
  parameters.l2 = number(file["params"]["l2"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const points::Inputs<double> inputs;
  points::State<double> start;
  initial_state(prepared, start);
  REQUIRE(start.theta1() == number(file["initial"]["theta"][0]));
  REQUIRE(start.theta2_dot() == number(file["initial"]["rates"][1]));

  physics::follow<Points>(file["expected"]["samples"], prepared, inputs, start,
                          [&](const auto& sample, double t, const auto& state) {
                            // The motion is chaotic: errors grow a hundredfold until t = 5.
                            const double scale = t < 3 ? 10 : 1000;
                            CHECK(state.theta1() == close_to(sample["theta"][0], scale));
                            CHECK(state.theta2() == close_to(sample["theta"][1], scale));
                            points::Reactions<double> found;
                            REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
                            CHECK(-found.r1.generalized == close_to(sample["T1"], scale * 100));
                            CHECK(-found.r2.generalized == close_to(sample["T2"], scale * 100));
                          });
}

TEST_CASE("Atwood's machine has the acceleration, the tensions and the force on the axle of its closed form") {
  namespace atwood = gauss::atwood;
  const auto file = reference::read("atwood");
  atwood::Parameters<double> parameters;
  parameters.m1 = number(file["params"]["m1"]);
  parameters.m2 = number(file["params"]["m2"]);
  parameters.M = number(file["params"]["M"]);
  parameters.R = number(file["params"]["R"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const atwood::Inputs<double> inputs;
  atwood::State<double> state;
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  atwood::Derivative<double> derivative;
  REQUIRE(rhs(0.0, state, inputs, prepared, derivative) == gauss::Status::ok);
  CHECK(-derivative.y1_ddot() == Approx(number(file["expected"]["a"])).epsilon(1e-14));
  atwood::Reactions<double> found;
  REQUIRE(reactions(0.0, state, inputs, prepared, found) == gauss::Status::ok);
  CHECK(found.rope1.multiplier == Approx(number(file["expected"]["T1"])).epsilon(1e-14));
  CHECK(found.rope2.multiplier == Approx(number(file["expected"]["T2"])).epsilon(1e-14));
  CHECK(found.h.generalized == Approx(number(file["expected"]["axle"])).epsilon(1e-14));
}
