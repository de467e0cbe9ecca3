// Bodies that turn about a point.
#include "catch_shim.hpp"
#include "follow.hpp"
#include "free_top.hpp"
#include "lagrange_top.hpp"

using physics::close_to;
using reference::number;

namespace top = gauss::lagrange_top;
namespace body = gauss::free_top;

GAUSS_MODEL(Top, top);
GAUSS_MODEL(Body, body);

TEST_CASE("Lagrange's top nutates as its elliptic functions say, and its pivot bears it") {
  const auto file = reference::read("lagrange_top");
  top::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.l = number(file["params"]["l"]);
  parameters.A = number(file["params"]["A"]);
  parameters.C = number(file["params"]["C"]);
  parameters.g = number(file["params"]["g"]);
  parameters.tilt = number(file["initial"]["theta"]);
  parameters.precession = number(file["initial"]["psidot"]);
  parameters.spin = number(file["initial"]["omega3"]);
  const auto prepared = prepare(parameters);
  const top::Inputs<double> inputs;
  top::State<double> start;
  initial_state(prepared, start);

  physics::follow<Top>(file["expected"]["samples"], prepared, inputs, start,
                       [&](const auto& sample, double t, const auto& state) {
                         const double cos_theta = 1 - 2 * (state.e1() * state.e1() + state.e2() * state.e2());
                         CHECK(cos_theta == close_to(sample["cos_theta"], 10));
                         CHECK(state.w3() == close_to(file["initial"]["omega3"], 100));
                         // The axis in space is (sin theta sin psi, -sin theta cos psi, cos theta).
                         const double axis_x = 2 * (state.e1() * state.e3() + state.e0() * state.e2());
                         const double axis_y = 2 * (state.e2() * state.e3() - state.e0() * state.e1());
                         CHECK(std::atan2(axis_x, -axis_y) ==
                               Approx(std::remainder(number(sample["psi"]), 4 * std::acos(0.0))).margin(1e-8));
                         top::JointReactions<double> joints;
                         REQUIRE(joint_reactions(t, state, inputs, prepared, joints) == gauss::Status::ok);
                         CHECK(joints.pivot.force[2] == close_to(sample["pivot_reaction_z"], 1000));
                         CHECK(joints.pivot.force[0] == close_to(sample["pivot_reaction_xy_kernel"][0], 1000));
                         CHECK(joints.pivot.force[1] == close_to(sample["pivot_reaction_xy_kernel"][1], 1000));
                         for (const double moment : joints.pivot.moment) CHECK(moment == Approx(0).margin(1e-12));
                       });
}

TEST_CASE("a free body turns as Euler's elliptic functions say, and nothing holds it") {
  const auto file = reference::read("euler_free_top");
  body::Parameters<double> parameters;
  parameters.A = number(file["params"]["I"][0]);
  parameters.B = number(file["params"]["I"][1]);
  parameters.C = number(file["params"]["I"][2]);
  const auto prepared = prepare(parameters);
  const body::Inputs<double> inputs;
  body::State<double> start;
  initial_state(prepared, start);
  REQUIRE(start.float_wy() == number(file["initial"]["omega"][1]));
  REQUIRE(start.float_wz() == number(file["initial"]["omega"][2]));

  physics::follow<Body>(file["expected"]["samples"], prepared, inputs, start,
                        [&](const auto& sample, double t, const auto& state) {
                          CHECK(state.float_wx() == close_to(sample["omega"][0]));
                          CHECK(state.float_wy() == close_to(sample["omega"][1]));
                          CHECK(state.float_wz() == close_to(sample["omega"][2]));
                          body::JointReactions<double> joints;
                          REQUIRE(joint_reactions(t, state, inputs, prepared, joints) == gauss::Status::ok);
                          for (std::size_t i = 0; i < 3; ++i) {
                            CHECK(joints.float_.force[i] == Approx(0).margin(1e-13));
                            CHECK(joints.float_.moment[i] == Approx(0).margin(1e-13));
                          }
                        });
}
