// Linkages, gimbals, driven pendulums and a cart, against Newton's and Euler's equations of their bodies (tools/oracles).
#include "cart_with_wheels.hpp"
#include "gyroscope_in_gimbals.hpp"
#include "iftomm_a02.hpp"
#include "iftomm_a02_parallel.hpp"
#include "pendulum_moving_pivot.hpp"
#include "pendulum_varying_length.hpp"
#include "slider_crank.hpp"
#include "states.hpp"
#include "two_loops.hpp"

using physics::check_joint;
using physics::check_motion;
using physics::check_states;
using physics::check_vector;
using physics::size_of_forces;
using reference::Json;
using reference::number;

namespace crank = gauss::slider_crank;
namespace gyro = gauss::gyroscope_in_gimbals;
namespace length = gauss::pendulum_varying_length;
namespace pivot = gauss::pendulum_moving_pivot;
namespace cart = gauss::cart_with_wheels;
namespace bars = gauss::iftomm_a02;

GAUSS_MODEL(Crank, crank);
GAUSS_MODEL(Gyro, gyro);
GAUSS_MODEL(Length, length);
GAUSS_MODEL(Pivot, pivot);
GAUSS_MODEL(Cart, cart);
GAUSS_MODEL(Bars, bars);
GAUSS_MODEL(TwoLoops, gauss::two_loops);
GAUSS_MODEL(FortyLoops, gauss::iftomm_a02_parallel);

TEST_CASE("a slider-crank moves as Newton and Euler say, with the forces in its pins and the guide's normal force") {
  const auto file = reference::read("slider_crank");
  const auto prepared = prepare(crank::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const crank::State<double>& state,
                                const crank::Inputs<double>& inputs, double margin) {
    crank::JointReactions<double> joints;
    REQUIRE(joint_reactions(0.0, state, inputs, prepared, joints) == gauss::Status::ok);
    check_joint(sample["forces"], "O", joints.O, margin);
    check_joint(sample["forces"], "A", joints.A, margin);
    check_joint(sample["forces"], "guide", joints.guide, margin);
    crank::ReactionForces<double> forces;
    REQUIRE(reaction_forces(0.0, state, inputs, prepared, forces) == gauss::Status::ok);
    check_vector(sample["forces"]["B"],
                 std::array<double, 3>{forces.pin_x.force_on_B[0], forces.pin_y.force_on_B[1], 0}, margin);
  };
  const auto inputs_of = [](const Json& sample) {
    crank::Inputs<double> inputs;
    inputs.torque = number(sample["inputs"]["torque"]);
    inputs.push = number(sample["inputs"]["push"]);
    return inputs;
  };
  check_states<Crank>(file, prepared, inputs_of, check_forces);
  crank::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  check_motion<Crank>(file, prepared, crank::Inputs<double>{}, start, check_forces);
}

TEST_CASE("a gyroscope turns its gimbals as Newton and Euler say, and its bearings transmit their forces and moments") {
  const auto file = reference::read("gyroscope_in_gimbals");
  const auto prepared = prepare(gyro::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const gyro::State<double>& state,
                                const gyro::Inputs<double>& inputs, double margin) {
    gyro::JointReactions<double> joints;
    REQUIRE(joint_reactions(0.0, state, inputs, prepared, joints) == gauss::Status::ok);
    check_joint(sample["forces"], "column", joints.column, margin);
    check_joint(sample["forces"], "trunnion", joints.trunnion, margin);
    check_joint(sample["forces"], "spindle", joints.spindle, margin);
  };
  check_states<Gyro>(
      file, prepared, [](const Json&) { return gyro::Inputs<double>{}; }, check_forces);
  gyro::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  check_motion<Gyro>(file, prepared, gyro::Inputs<double>{}, start, check_forces);
}

TEST_CASE("a gyroscope in gimbals keeps its spin, its angular momentum about the vertical, and its energy") {
  const gyro::Parameters<double> p;
  const auto prepared = prepare(p);
  const gyro::Inputs<double> inputs;
  gyro::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  struct Kept {
    double spin, vertical, energy;
  };
  // The momenta of the classical Lagrangian, 2T = (Co + Bi s^2 + Ci c^2 + A' s^2) psi'^2 + (Ai + A') theta'^2 + C w^2.
  const auto kept = [&p](const gyro::State<double>& state) {
    const double s = std::sin(state.theta()), c = std::cos(state.theta());
    const double across = p.A + p.m * p.l * p.l;
    const double spin = p.C * (state.phi_dot() + state.psi_dot() * c);
    const double about_vertical = p.Co + p.Bi * s * s + p.Ci * c * c + across * s * s;
    const double twice_kinetic = about_vertical * state.psi_dot() * state.psi_dot() +
                                 (p.Ai + across) * state.theta_dot() * state.theta_dot() + spin * spin / p.C;
    return Kept{spin, about_vertical * state.psi_dot() + spin * c, twice_kinetic / 2 + p.m * p.g * p.l * c};
  };
  const Kept first = kept(start);
  const auto model = gauss::integrate::bind_model<Gyro>(prepared, inputs);
  gauss::simulate::Simulation simulation(model, start);
  for (const double t : {0.5, 1.0, 2.0, 5.0}) {
    REQUIRE(simulation.advance_to(t));
    const Kept now = kept(simulation.state());
    CHECK(now.spin == Approx(first.spin).epsilon(1e-10));
    CHECK(now.vertical == Approx(first.vertical).epsilon(1e-10));
    CHECK(now.energy == Approx(first.energy).epsilon(1e-10));
  }
}

TEST_CASE("a pendulum whose length follows a law in time swings as Newton says, with the force in its rod") {
  const auto file = reference::read("pendulum_varying_length");
  const auto prepared = prepare(length::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const length::State<double>& state,
                                const length::Inputs<double>& inputs, double margin) {
    length::ReactionForces<double> forces;
    REQUIRE(reaction_forces(number(sample["t"]), state, inputs, prepared, forces) == gauss::Status::ok);
    check_vector(sample["forces"]["rod"], forces.r.force_on_bob, margin);
  };
  check_states<Length>(
      file, prepared, [](const Json&) { return length::Inputs<double>{}; }, check_forces);
  length::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  check_motion<Length>(file, prepared, length::Inputs<double>{}, start, check_forces);
}

TEST_CASE(
    "a rod on a pivot that shakes moves as Newton and Euler say, with the force in the pivot and that of the drive") {
  const auto file = reference::read("pendulum_moving_pivot");
  const auto prepared = prepare(pivot::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const pivot::State<double>& state,
                                const pivot::Inputs<double>& inputs, double margin) {
    const double t = number(sample["t"]);
    pivot::JointReactions<double> joints;
    REQUIRE(joint_reactions(t, state, inputs, prepared, joints) == gauss::Status::ok);
    check_joint(sample["forces"], "pivot", joints.pivot, margin);
    pivot::Reactions<double> found;
    REQUIRE(reactions(t, state, inputs, prepared, found) == gauss::Status::ok);
    CHECK(found.height.generalized == Approx(number(sample["forces"]["pivot"][2])).epsilon(0).margin(margin));
  };
  check_states<Pivot>(
      file, prepared, [](const Json&) { return pivot::Inputs<double>{}; }, check_forces);
  pivot::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  check_motion<Pivot>(file, prepared, pivot::Inputs<double>{}, start, check_forces);
}

TEST_CASE("a fast shaking pivot keeps a rod upright, and a slow one lets it fall") {
  const auto largest_tilt = [](double rate) {
    pivot::Parameters<double> parameters;
    parameters.Omega = rate;
    const auto prepared = prepare(parameters);
    pivot::State<double> start;
    REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
    const auto model = gauss::integrate::bind_model<Pivot>(prepared, pivot::Inputs<double>{});
    gauss::simulate::Simulation simulation(model, start);
    double tilt = 0;
    for (int i = 1; i <= 100; ++i) {
      REQUIRE(simulation.advance_to(0.05 * i));
      tilt = std::max(tilt, std::abs(simulation.state().theta()));
    }
    return tilt;
  };
  // Kapitza: upright is stable where (stroke Omega)^2 > 2 g l', with l' = 2 l / 3 for a rod: Omega > 114 rad/s here.
  CHECK(largest_tilt(200) < 0.2);
  CHECK(largest_tilt(80) > 1.5);
}

TEST_CASE(
    "a cart on two wheels and a castor climbs as Newton and Euler say, with each force of the plane and in the axles") {
  const auto file = reference::read("cart_with_wheels");
  const auto prepared = prepare(cart::Parameters<double>{});
  const auto check_forces = [&](const Json& sample, const cart::State<double>& state,
                                const cart::Inputs<double>& inputs, double margin) {
    const Json& expected = sample["forces"];
    cart::JointReactions<double> joints;
    REQUIRE(joint_reactions(0.0, state, inputs, prepared, joints) == gauss::Status::ok);
    check_joint(expected, "left_axle", joints.left_axle, margin);
    check_joint(expected, "right_axle", joints.right_axle, margin);
    cart::ReactionForces<double> f;
    REQUIRE(reaction_forces(0.0, state, inputs, prepared, f) == gauss::Status::ok);
    std::array<double, 3> left{}, right{};
    for (std::size_t i = 0; i < 3; ++i) {
      left[i] = f.left_rolls.force_on_left_wheel[i] + f.sideways.force_on_left_wheel[i] +
                f.left_stands.force_on_left_contact[i];
      right[i] = f.right_rolls.force_on_right_wheel[i] + f.right_stands.force_on_right_contact[i];
    }
    check_vector(expected["left_contact"], left, margin);
    check_vector(expected["right_contact"], right, margin);
    check_vector(expected["castor"], f.castor_stands.force_on_castor, margin);
  };
  const auto inputs_of = [](const Json& sample) {
    cart::Inputs<double> inputs;
    inputs.left_torque = number(sample["inputs"]["left_torque"]);
    inputs.right_torque = number(sample["inputs"]["right_torque"]);
    return inputs;
  };
  check_states<Cart>(file, prepared, inputs_of, check_forces);
  cart::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  check_motion<Cart>(file, prepared, cart::Inputs<double>{}, start, check_forces);
}

TEST_CASE(
    "the bars of an N-four-bar mechanism swing as the reference says until they lie flat, and keep their energy") {
  const auto file = reference::read("iftomm_a02_n_four_bar");
  bars::Parameters<double> p;
  p.L = number(file["params"]["L"]);
  p.m = number(file["params"]["m"]);
  p.g = number(file["params"]["g"]);
  const auto prepared = prepare(p);
  bars::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  const auto model = gauss::integrate::bind_model<Bars>(prepared, bars::Inputs<double>{});
  gauss::simulate::Simulation simulation(model, start);

  const Json sample = file["expected"]["N2"]["samples"][0];
  REQUIRE(number(sample["t"]) == 0.5);
  REQUIRE(simulation.advance_to(0.5));
  bars::State<double> state = simulation.state();
  CHECK(p.L * std::cos(state.theta0()) == physics::close_to(sample["x"], 10));
  CHECK(p.L * std::sin(state.theta0()) == physics::close_to(sample["y"], 10));
  CHECK(-p.L * std::sin(state.theta0()) * state.theta0_dot() == physics::close_to(sample["vx"], 10));
  CHECK(p.L * std::cos(state.theta0()) * state.theta0_dot() == physics::close_to(sample["vy"], 10));

  // Flat at 0.714 s. Until then the closed form has theta'^2 = (v/L)^2 + 2 (g/L) (b/a) (1 - y/L).
  const double b_over_a = (3.0 / 2 + 2) / (3.0 / 3 + 2);
  for (const double t : {0.6, 0.65, 0.7, 0.71}) {
    REQUIRE(simulation.advance_to(t));
    state = simulation.state();
    const double squared = std::pow(p.v / p.L, 2) + 2 * p.g / p.L * b_over_a * (1 - std::sin(state.theta0()));
    for (const double rate : {state.theta0_dot(), state.theta1_dot(), state.theta2_dot()})
      CHECK(rate * rate == Approx(squared).epsilon(1e-9));
  }
}

TEST_CASE(
    "where bars lie flat a simulation goes through, or stops there and says so, and never takes their energy away") {
  // There the loops say less than elsewhere, and what projection makes of a state need be no motion.
  const auto prepared = prepare(bars::Parameters<double>{});
  bars::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  bars::Energy<double> at_start{};
  REQUIRE(energy(0.0, start, prepared, at_start) == gauss::Status::ok);
  int stopped = 0;
  // Times that are asked for decide where steps end.
  for (const double first : {0.3, 0.5, 0.61, 0.66, 0.69, 0.7, 0.71}) {
    const auto model = gauss::integrate::bind_model<Bars>(prepared, bars::Inputs<double>{});
    gauss::simulate::Simulation simulation(model, start);
    bool goes_on = true;
    for (double t = first; t < 0.8 && goes_on; t += 0.01) goes_on = simulation.advance_to(t);
    INFO("first " << first << ", until " << simulation.time() << ": " << name(simulation.report().outcome));
    bars::Energy<double> at_end{};
    (void)energy(simulation.time(), simulation.state(), prepared, at_end);
    CHECK(at_end.total == Approx(at_start.total).epsilon(1e-8));
    if (goes_on) continue;
    ++stopped;
    CHECK(simulation.report().outcome == gauss::simulate::Outcome::constraints_lost);
    // How near it comes depends on rounding.
    CHECK(simulation.time() == Approx(0.714356).margin(2e-4));
  }
  CHECK(stopped <= 1);
}

namespace {

template <class Model>
void check_parallel_bars(const Json& expected) {
  const auto prepared = Model::prepare(typename Model::template Parameters<double>{});
  typename Model::template State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  const auto model = gauss::integrate::bind_model<Model>(prepared, typename Model::template Inputs<double>{});
  gauss::simulate::Simulation simulation(model, start);
  for (const Json& sample : expected["samples"]) {
    const double t = number(sample["t"]);
    REQUIRE(simulation.advance_to(t));
    const auto state = simulation.state();
    // The error of a step of an integrator adds up, and is turned into one of position by the speed of 7 m/s.
    const double factor = 10 * (1 + t);
    CHECK(std::cos(state.theta()) == physics::close_to(sample["x"], factor));
    CHECK(std::sin(state.theta()) == physics::close_to(sample["y"], factor));
    CHECK(-std::sin(state.theta()) * state.theta_dot() == physics::close_to(sample["vx"], 10 * factor));
    CHECK(std::cos(state.theta()) * state.theta_dot() == physics::close_to(sample["vy"], 10 * factor));
  }
}

}  // namespace

TEST_CASE("the bars of N-four-bar mechanisms with 2 and with 40 loops turn over for 20 s as the reference says") {
  const auto file = reference::read("iftomm_a02_n_four_bar");
  check_parallel_bars<TwoLoops>(file["expected"]["N2"]);
  check_parallel_bars<FortyLoops>(file["expected"]["N40"]);
}
