#include "catch_shim.hpp"
#include "chaplygin_sleigh.hpp"
#include "chaplygin_sleigh_speeds.hpp"
#include "follow.hpp"

namespace sleigh = gauss::chaplygin_sleigh;
namespace in_speeds = gauss::chaplygin_sleigh_speeds;
using physics::close_to;

GAUSS_MODEL(Sleigh, sleigh);
GAUSS_MODEL(SleighInSpeeds, in_speeds);

namespace {

double forward_speed(const sleigh::State<double>& state) {
  return state.x_dot() * std::cos(state.theta()) + state.y_dot() * std::sin(state.theta());
}

}  // namespace

TEST_CASE("Chaplygin's sleigh turns around and runs forwards as its closed form says, lateral reaction included") {
  const auto file = reference::read("chaplygin_sleigh");
  const auto& initial = file["initial"];
  sleigh::Parameters<double> parameters;
  parameters.m = reference::number(file["params"]["m"]);
  parameters.Jc = reference::number(file["params"]["I"]);
  parameters.a = reference::number(file["params"]["a"]);
  const auto prepared = prepare(parameters);

  sleigh::State<double> start;
  initial_state(prepared, start);
  REQUIRE(start.x() == reference::number(initial["x"]));
  REQUIRE(start.y() == reference::number(initial["y"]));
  REQUIRE(start.theta() == reference::number(initial["theta"]));
  REQUIRE(forward_speed(start) == reference::number(initial["u"]));
  REQUIRE(start.theta_dot() == reference::number(initial["omega"]));

  const sleigh::Inputs<double> inputs;
  physics::follow<Sleigh>(file["expected"]["samples"], prepared, inputs, start,
                          [&](const auto& sample, double t, const auto& state) {
                            CHECK(forward_speed(state) == close_to(sample["u"]));
                            CHECK(state.theta_dot() == close_to(sample["omega"]));
                            CHECK(state.theta() == close_to(sample["theta"]));
                            CHECK(state.x() == close_to(sample["blade_xy"][0]));
                            CHECK(state.y() == close_to(sample["blade_xy"][1]));

                            sleigh::Reactions<double> found;
                            REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
                            CHECK(found.blade.multiplier == close_to(sample["lateral_reaction"]));

                            sleigh::ReactionForces<double> forces;
                            REQUIRE(reaction_forces(t, state, inputs, prepared, forces) == gauss::Status::ok);
                            CHECK(forces.blade.force_on_sleigh[0] ==
                                  Approx(-std::sin(state.theta()) * found.blade.multiplier).margin(1e-12));
                            CHECK(forces.blade.force_on_sleigh[1] ==
                                  Approx(std::cos(state.theta()) * found.blade.multiplier).margin(1e-12));
                            // It acts at the blade, which is the point that the model states.
                            CHECK(forces.blade.moment_on_sleigh[2] == Approx(0).margin(1e-12));
                          });
}

TEST_CASE("the sleigh in speeds along its axes runs the same way, with the same reaction") {
  const auto file = reference::read("chaplygin_sleigh");
  in_speeds::Parameters<double> parameters;
  parameters.m = reference::number(file["params"]["m"]);
  parameters.Jc = reference::number(file["params"]["I"]);
  parameters.a = reference::number(file["params"]["a"]);
  const auto prepared = prepare(parameters);
  in_speeds::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  REQUIRE(start.u() == reference::number(file["initial"]["u"]));
  REQUIRE(start.w() == 0);
  REQUIRE(start.theta_dot() == reference::number(file["initial"]["omega"]));

  const in_speeds::Inputs<double> inputs;
  physics::follow<SleighInSpeeds>(file["expected"]["samples"], prepared, inputs, start,
                                  [&](const auto& sample, double t, const auto& state) {
                                    CHECK(state.u() == close_to(sample["u"]));
                                    CHECK(state.theta_dot() == close_to(sample["omega"]));
                                    CHECK(state.theta() == close_to(sample["theta"]));
                                    CHECK(state.x() == close_to(sample["blade_xy"][0]));
                                    CHECK(state.y() == close_to(sample["blade_xy"][1]));
                                    in_speeds::Reactions<double> found;
                                    REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
                                    CHECK(found.blade.multiplier == close_to(sample["lateral_reaction"]));
                                  });
}
