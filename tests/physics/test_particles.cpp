// Particles on curves and surfaces, by held coordinates and by equations.
#include "appell_hamel.hpp"
#include "bead_on_hoop.hpp"
#include "catch_shim.hpp"
#include "follow.hpp"
#include "particle_on_paraboloid.hpp"
#include "pendulum_cartesian.hpp"
#include "spherical_pendulum.hpp"

using physics::close_to;
using reference::number;

namespace appell = gauss::appell_hamel;
namespace hoop = gauss::bead_on_hoop;
namespace bowl = gauss::particle_on_paraboloid;
namespace bar = gauss::pendulum_cartesian;
namespace bob = gauss::spherical_pendulum;

GAUSS_MODEL(Appell, appell);
GAUSS_MODEL(Hoop, hoop);
GAUSS_MODEL(Bowl, bowl);
GAUSS_MODEL(Bar, bar);
GAUSS_MODEL(Bob, bob);

TEST_CASE("a bead on a rotating hoop feels the radial and the sideways force of its closed form") {
  const auto file = reference::read("bead_rotating_hoop");
  hoop::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.R = number(file["params"]["R"]);
  parameters.omega = number(file["params"]["omega"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const hoop::Inputs<double> inputs;
  hoop::State<double> start;
  initial_state(prepared, start);
  physics::follow<Hoop>(file["expected"]["samples"], prepared, inputs, start,
                        [&](const auto& sample, double t, const auto& state) {
                          CHECK(state.theta() == close_to(sample["theta"], 10));
                          CHECK(state.theta_dot() == close_to(sample["thetadot"], 10));
                          hoop::Reactions<double> found;
                          REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
                          CHECK(found.r.generalized == close_to(sample["N_radial"], 10));
                          // The moment about the axis over its arm.
                          const double arm = parameters.R * std::sin(state.theta());
                          CHECK(found.phi.generalized / arm == close_to(sample["N_phi"], 10));
                        });
}

TEST_CASE("a particle in a bowl moves as the reference says, and the bowl presses on it") {
  const auto file = reference::read("particle_on_paraboloid");
  bowl::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.a = number(file["params"]["a"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const bowl::Inputs<double> inputs;
  bowl::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  CHECK(start.z() == Approx(parameters.a));  // the surface says so, at x = 1
  physics::follow<Bowl>(
      file["expected"]["samples"], prepared, inputs, start, [&](const auto& sample, double t, const auto& state) {
        CHECK(state.x() == close_to(sample["xy"][0], 10));
        CHECK(state.y() == close_to(sample["xy"][1], 10));
        CHECK(state.x_dot() == close_to(sample["vxy"][0], 10));
        CHECK(state.z() - parameters.a * (state.x() * state.x() + state.y() * state.y()) == Approx(0).margin(1e-14));
        bowl::ReactionForces<double> forces;
        REQUIRE(reaction_forces(t, state, inputs, prepared, forces) == gauss::Status::ok);
        const auto& N = forces.surface.force_on_bead;
        CHECK(std::sqrt(N[0] * N[0] + N[1] * N[1] + N[2] * N[2]) == close_to(sample["N"], 100));
        CHECK(N[2] > 0);
      });
}

TEST_CASE("a spherical pendulum in Cartesian coordinates swings as its elliptic functions say, string included") {
  const auto file = reference::read("spherical_pendulum");
  bob::Parameters<double> parameters;
  parameters.m = number(file["params"]["m"]);
  parameters.l = number(file["params"]["l"]);
  parameters.g = number(file["params"]["g"]);
  const auto prepared = prepare(parameters);
  const bob::Inputs<double> inputs;
  bob::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  CHECK(start.z() == Approx(-parameters.l * std::cos(number(file["initial"]["theta"]))));
  physics::follow<Bob>(file["expected"]["samples"], prepared, inputs, start,
                       [&](const auto& sample, double t, const auto& state) {
                         CHECK(state.x() == close_to(sample["xyz"][0], 10));
                         CHECK(state.y() == close_to(sample["xyz"][1], 10));
                         CHECK(state.z() == close_to(sample["xyz"][2], 10));
                         bob::Reactions<double> found;
                         REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
                         CHECK(-found.string.multiplier == close_to(sample["tension"], 100));
                       });
}

TEST_CASE("IFToMM A01: a pendulum in Cartesian coordinates keeps to its elliptic functions") {
  const auto file = reference::read("iftomm_a01_pendulum");
  const auto prepared = prepare(bar::Parameters<double>{});
  const bar::Inputs<double> inputs;
  bar::State<double> start{};
  start.x() = number(file["initial"]["x"]);
  start.y() = number(file["initial"]["y"]);
  reference::Json samples = file["expected"]["samples"];
  samples.erase(samples.begin() + 5, samples.end());  // to t = 10
  physics::follow<Bar>(samples, prepared, inputs, start, [&](const auto& sample, double t, const auto& state) {
    CHECK(state.x() == close_to(sample["x"], 10));
    CHECK(state.y() == close_to(sample["y"], 10));
    bar::Reactions<double> found;
    REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
    CHECK(-found.bar.multiplier == close_to(sample["tension"], 100));  // times L = 1
  });
}

// m x'' = L a^2 x', m y'' = L a^2 y', m z'' = -m g - L b^2 z' with a^2 v^2 = b^2 z'^2 over level speed v give L = -m g / ((a^2 + b^2) z'):
// the heading stays, and v and z' change evenly.
TEST_CASE("a load on Appell's wheel falls evenly, and runs straight ahead, on the force that makes it do so") {
  const appell::Parameters<double> p;
  const auto prepared = prepare(p);
  appell::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  const double v = std::hypot(start.x_dot(), start.y_dot());
  REQUIRE(start.z_dot() == Approx(-p.a / p.b * v).epsilon(1e-14));
  const double a2 = p.a * p.a, b2 = p.b * p.b;
  const double falling = -p.g * a2 / (a2 + b2), ahead = p.g * p.a * p.b / (a2 + b2);
  const double heading[] = {start.x_dot() / v, start.y_dot() / v};

  const auto model = gauss::integrate::bind_model<Appell>(prepared, appell::Inputs<double>{});
  gauss::simulate::Simulation simulation(model, start);
  for (const double t : {0.0, 0.5, 1.0, 2.0, 4.0}) {
    INFO("t = " << t);
    REQUIRE(simulation.advance_to(t));
    const appell::State<double> state = simulation.state();
    const auto is = [](double value) { return Approx(value).epsilon(0).margin(physics::k_margin * 10); };
    const double way = v * t + ahead * t * t / 2, speed = v + ahead * t;
    CHECK(state.x() == is(start.x() + heading[0] * way));
    CHECK(state.y() == is(start.y() + heading[1] * way));
    CHECK(state.z() == is(start.z() + start.z_dot() * t + falling * t * t / 2));
    CHECK(state.x_dot() == is(heading[0] * speed));
    CHECK(state.y_dot() == is(heading[1] * speed));
    CHECK(state.z_dot() == is(start.z_dot() + falling * t));

    appell::Reactions<double> found;
    REQUIRE(reactions(t, state, appell::Inputs<double>{}, prepared, found) == gauss::Status::ok);
    // The row of the constraint is twice (a^2 x', a^2 y', -b^2 z').
    CHECK(found.appell.multiplier == is(-p.m * p.g / (2 * (a2 + b2) * state.z_dot())));
    appell::ReactionForces<double> forces;
    REQUIRE(reaction_forces(t, state, appell::Inputs<double>{}, prepared, forces) == gauss::Status::ok);
    const double expected[] = {p.m * ahead * heading[0], p.m * ahead * heading[1], p.m * (falling + p.g)};
    for (int i = 0; i < 3; ++i) CHECK(forces.appell.force_on_load[i] == is(expected[i]));
  }
}
