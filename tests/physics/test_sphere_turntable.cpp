#include "catch_shim.hpp"
#include "follow.hpp"
#include "sphere_turntable.hpp"

namespace ball = gauss::sphere_turntable;
using physics::close_to;
using reference::number;

GAUSS_MODEL(Ball, ball);

TEST_CASE("a ball on a turning table runs along a circle, friction and normal force included") {
  const auto file = reference::read("sphere_turntable");
  const auto& initial = file["initial"];
  ball::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.r = number(file["params"]["r"]);
  parameters.Omega = number(file["params"]["Omega"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);

  ball::State<double> start;
  initial_state(prepared, start);
  REQUIRE(start.x() == number(initial["x"][0]));
  REQUIRE(start.y() == number(initial["x"][1]));
  REQUIRE(start.x_dot() == number(initial["v"][0]));
  REQUIRE(start.y_dot() == number(initial["v"][1]));
  REQUIRE(start.wz() == number(initial["omega_z"]));

  const ball::Inputs<double> inputs;
  const auto& centre = file["expected"]["centre"];
  physics::follow<Ball>(file["expected"]["samples"], prepared, inputs, start,
                        [&](const auto& sample, double t, const auto& state) {
                          CHECK(state.x() == close_to(sample["x"]));
                          CHECK(state.y() == close_to(sample["y"]));
                          CHECK(state.x_dot() == close_to(sample["vx"]));
                          CHECK(state.y_dot() == close_to(sample["vy"]));
                          CHECK(state.wz() == close_to(initial["omega_z"]));
                          CHECK(std::hypot(state.x() - number(centre[0]), state.y() - number(centre[1])) ==
                                close_to(file["expected"]["radius"]));

                          ball::ReactionForces<double> forces;
                          REQUIRE(reaction_forces(t, state, inputs, prepared, forces) == gauss::Status::ok);
                          for (std::size_t i = 0; i < 2; ++i) {
                            CHECK(forces.rolling_x.force_on_ball[i] + forces.rolling_y.force_on_ball[i] ==
                                  close_to(sample["friction"][i]));
                          }
                          CHECK(forces.z.force_on_ball[2] == close_to(sample["normal"]));
                        });
}
