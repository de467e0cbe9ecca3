#include "catch_shim.hpp"
#include "follow.hpp"
#include "nonholonomic_particle.hpp"

namespace particle = gauss::nonholonomic_particle;
using physics::close_to;

GAUSS_MODEL(Particle, particle);

TEST_CASE("a particle with z' = y x' follows its closed form, multiplier included") {
  const auto file = reference::read("nonholonomic_particle");
  const auto& initial = file["initial"];
  particle::Parameters<double> parameters;
  parameters.m = reference::number(file["params"]["m"]);
  parameters.c = reference::number(initial["c"]);
  parameters.y_0 = reference::number(initial["y"]);
  const auto prepared = prepare(parameters);

  particle::State<double> start;
  initial_state(prepared, start);
  REQUIRE(start.x() == reference::number(initial["x"]));
  REQUIRE(start.z() == reference::number(initial["z"]));
  REQUIRE(start.y_dot() == reference::number(initial["ydot"]));

  const particle::Inputs<double> inputs;
  physics::follow<Particle>(file["expected"]["samples"], prepared, inputs, start,
                            [&](const auto& sample, double t, const auto& state) {
                              CHECK(state.x() == close_to(sample["x"]));
                              CHECK(state.y() == close_to(sample["y"]));
                              CHECK(state.z() == close_to(sample["z"]));

                              particle::Reactions<double> found;
                              REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
                              CHECK(found.slope.multiplier == close_to(sample["lambda"]));
                              // (-y, 0, 1) lambda
                              CHECK(found.slope.generalized[0] == Approx(-state.y() * found.slope.multiplier));
                              CHECK(found.slope.generalized[1] == 0);
                              CHECK(found.slope.generalized[2] == Approx(found.slope.multiplier));
                            });
}
