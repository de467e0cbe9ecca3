// Bodies that roll, described by `rolls`.
#include "catch_shim.hpp"
#include "chaplygin_sphere.hpp"
#include "follow.hpp"
#include "rattleback.hpp"
#include "rolling_disc.hpp"
#include "sphere_on_incline.hpp"

using physics::close_to;
using reference::number;

namespace disc = gauss::rolling_disc;
namespace sphere = gauss::chaplygin_sphere;
namespace stone = gauss::rattleback;
namespace slope = gauss::sphere_on_incline;

GAUSS_MODEL(Disc, disc);
GAUSS_MODEL(Sphere, sphere);
GAUSS_MODEL(Stone, stone);

TEST_CASE("a thin disc rolls as its reduced equations say, contact force included") {
  const auto file = reference::read("rolling_disc");
  disc::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.R = number(file["params"]["R"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const disc::Inputs<double> inputs;
  disc::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  REQUIRE(start.theta() == number(file["initial"]["theta"]));
  REQUIRE(start.theta_dot() == number(file["initial"]["omega"][0]));

  physics::follow<Disc>(file["expected"]["general"], prepared, inputs, start,
                        [&](const auto& sample, double t, const auto& state) {
                          CHECK(state.theta() == close_to(sample["theta"], 10));
                          CHECK(state.psi() == close_to(sample["psi"], 10));
                          CHECK(state.phi() == close_to(sample["phi"], 10));
                          CHECK(state.x() == close_to(sample["centre_xy"][0], 10));
                          CHECK(state.y() == close_to(sample["centre_xy"][1], 10));
                          CHECK(state.psi_dot() * std::sin(state.theta()) == close_to(sample["omega"][1], 10));
                          disc::ReactionForces<double> forces;
                          REQUIRE(reaction_forces(t, state, inputs, prepared, forces) == gauss::Status::ok);
                          CHECK(forces.rim_x.force_on_disc[0] == close_to(sample["contact_force_xyz"][0], 100));
                          CHECK(forces.rim_y.force_on_disc[1] == close_to(sample["contact_force_xyz"][1], 100));
                          disc::Reactions<double> found;
                          REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
                          CHECK(found.gap.generalized == close_to(sample["contact_force_xyz"][2], 100));
                        });
}

TEST_CASE("Chaplygin's sphere rolls as its reduced equations say, contact force included") {
  const auto file = reference::read("chaplygin_sphere");
  sphere::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.r = number(file["params"]["r"]);
  parameters.I1 = number(file["params"]["I"][0]);
  parameters.I2 = number(file["params"]["I"][1]);
  parameters.I3 = number(file["params"]["I"][2]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const sphere::Inputs<double> inputs;
  sphere::State<double> start;
  initial_state(prepared, start);
  REQUIRE(start.w2() == number(file["initial"]["omega"][1]));

  physics::follow<Sphere>(
      file["expected"]["samples"], prepared, inputs, start, [&](const auto& sample, double t, const auto& state) {
        CHECK(state.x() == close_to(sample["centre_xy"][0], 10));
        CHECK(state.y() == close_to(sample["centre_xy"][1], 10));
        CHECK(state.w1() == close_to(sample["omega_body"][0], 10));
        CHECK(state.w2() == close_to(sample["omega_body"][1], 10));
        CHECK(state.w3() == close_to(sample["omega_body"][2], 10));
        // The vertical in body axes is the last row of the rotation.
        CHECK(2 * (state.e1() * state.e3() - state.e0() * state.e2()) == close_to(sample["gamma_body"][0], 10));
        sphere::ReactionForces<double> forces;
        REQUIRE(reaction_forces(t, state, inputs, prepared, forces) == gauss::Status::ok);
        CHECK(forces.plane_x.force_on_ball[0] == close_to(sample["contact_force_xyz"][0], 100));
        CHECK(forces.plane_y.force_on_ball[1] == close_to(sample["contact_force_xyz"][1], 100));
        CHECK(forces.z.force_on_ball[2] == close_to(sample["contact_force_xyz"][2], 100));
      });
}

TEST_CASE("a rattleback turns against its spin as the reference says") {
  const auto file = reference::read("rattleback");
  const auto prepared = prepare(stone::Parameters<double>{});
  const stone::Inputs<double> inputs;
  stone::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);

  stone::Reactions<double> at_start;
  REQUIRE(reactions(0.0, start, inputs, prepared, at_start) == gauss::Status::ok);
  CHECK(at_start.plane_x.multiplier == close_to(file["expected"]["contact_force_t0_xyz"][0], 10));
  CHECK(at_start.plane_y.multiplier == close_to(file["expected"]["contact_force_t0_xyz"][1], 10));
  CHECK(at_start.gap.generalized == close_to(file["expected"]["contact_force_t0_xyz"][2], 10));

  // The reference is good to 1e-8 until t = 10.
  reference::Json samples = file["expected"]["samples"];
  samples.erase(samples.begin() + 5, samples.end());
  const auto near = [](const reference::Json& value) { return Approx(number(value)).epsilon(0).margin(2e-8); };
  physics::follow<Stone>(samples, prepared, inputs, start, [&](const auto& sample, double, const auto& state) {
    CHECK(state.alpha() == near(sample["alpha"]));
    CHECK(state.beta() == near(sample["beta"]));
    CHECK(state.gamma() == near(sample["gamma"]));
    const double spin = state.alpha_dot() * std::sin(state.beta()) +
                        state.gamma_dot() * std::cos(state.alpha()) * std::cos(state.beta());
    CHECK(spin == near(sample["omega_body"][2]));
  });
}

TEST_CASE("a ball runs down a slope at 5/7 of the acceleration of a particle, and friction and plane hold it") {
  const auto file = reference::read("sphere_on_incline");
  slope::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.r = number(file["params"]["r"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const slope::Inputs<double> inputs;
  slope::State<double> state;
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  CHECK(state.x_dot() == Approx(number(file["initial"]["v"][0])));
  CHECK(state.y_dot() == Approx(number(file["initial"]["v"][1])));
  slope::Derivative<double> derivative;
  REQUIRE(rhs(0.0, state, inputs, prepared, derivative) == gauss::Status::ok);
  CHECK(derivative.x_ddot() == Approx(number(file["expected"]["acceleration"])).epsilon(1e-14));
  CHECK(derivative.y_ddot() == Approx(0).margin(1e-14));
  slope::ReactionForces<double> forces;
  REQUIRE(reaction_forces(0.0, state, inputs, prepared, forces) == gauss::Status::ok);
  CHECK(forces.plane_x.force_on_ball[0] == Approx(number(file["expected"]["friction"])).epsilon(1e-14));
  CHECK(forces.z.force_on_ball[2] == Approx(number(file["expected"]["normal"])).epsilon(1e-14));
}
