// Driven, skating and pushed by forces of every kind, against Newton's and Euler's equations of the bodies (tools/oracles).
#include "functions.hpp"
#include "rotor_on_platform.hpp"
#include "skater_quaternion.hpp"
#include "states.hpp"

using physics::check_motion;
using physics::check_states;
using physics::check_vector;
using reference::Json;
using reference::number;

namespace rotor = gauss::rotor_on_platform;
namespace skater = gauss::skater_quaternion;
namespace wagon = gauss::functions;

GAUSS_MODEL(Rotor, rotor);
GAUSS_MODEL(Skater, skater);
GAUSS_MODEL(Wagon, wagon);

TEST_CASE("a rotor on a driven platform turns as Euler says, and the drive gives the moment about the vertical") {
  const auto file = reference::read("rotor_on_platform");
  const auto prepared = prepare(rotor::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const rotor::State<double>& state,
                                const rotor::Inputs<double>& inputs, double margin) {
    rotor::Reactions<double> found;
    REQUIRE(reactions(number(sample["t"]), state, inputs, prepared, found) == gauss::Status::ok);
    CHECK(found.platform.generalized == Approx(number(sample["forces"]["platform"][2])).epsilon(0).margin(margin));
  };
  const auto inputs_of = [](const Json& sample) {
    rotor::Inputs<double> inputs;
    inputs.motor = number(sample["inputs"]["motor"]);
    return inputs;
  };
  check_states<Rotor>(file, prepared, inputs_of, check_forces);
  rotor::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  check_motion<Rotor>(file, prepared, rotor::Inputs<double>{}, start, check_forces);
}

TEST_CASE(
    "a body on a skate, its attitude a quaternion, moves as Newton and Euler say, on the forces of ice and blade") {
  const auto file = reference::read("skater_quaternion");
  const auto prepared = prepare(skater::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const skater::State<double>& state,
                                const skater::Inputs<double>& inputs, double margin) {
    skater::ReactionForces<double> found;
    REQUIRE(reaction_forces(number(sample["t"]), state, inputs, prepared, found) == gauss::Status::ok);
    check_vector(sample["forces"]["blade"], found.blade.force_on_skater, margin);
    check_vector(sample["forces"]["z"], found.z.force_on_skater, margin);
  };
  const auto inputs_of = [](const Json& sample) {
    skater::Inputs<double> inputs;
    inputs.thrust = number(sample["inputs"]["thrust"]);
    return inputs;
  };
  check_states<Skater>(file, prepared, inputs_of, check_forces);
  skater::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  check_motion<Skater>(file, prepared, skater::Inputs<double>{}, start, check_forces);
}

TEST_CASE("forces with kinks, jumps and tables, and a clutch that is nonlinear in the velocities, act as Newton says") {
  const auto file = reference::read("functions");
  const auto prepared = prepare(wagon::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const wagon::State<double>& state,
                                const wagon::Inputs<double>& inputs, double margin) {
    wagon::Reactions<double> found;
    REQUIRE(reactions(number(sample["t"]), state, inputs, prepared, found) == gauss::Status::ok);
    const Json& expected = sample["forces"];
    CHECK(found.z.generalized == Approx(number(expected["z"][2])).epsilon(0).margin(margin));
    CHECK(found.clutch.generalized[0] == Approx(number(expected["clutch"][0])).epsilon(0).margin(margin));
    const double along_rod =
        number(expected["r"][0]) * std::sin(state.phi()) - number(expected["r"][2]) * std::cos(state.phi());
    CHECK(found.r.generalized == Approx(along_rod).epsilon(0).margin(margin));
  };
  const auto inputs_of = [](const Json& sample) {
    wagon::Inputs<double> inputs;
    inputs.push = number(sample["inputs"]["push"]);
    return inputs;
  };
  REQUIRE(file["expected"]["states"].size() == 24);
  check_states<Wagon>(file, prepared, inputs_of, check_forces);
}
