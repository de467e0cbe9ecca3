// The paper's ball, in both descriptions, against its closed form (tests/reference/sphere_in_cylinder.json).
#include <algorithm>
#include <cmath>
#include <vector>

#include "catch_shim.hpp"
#include "follow.hpp"
#include "sphere/description.hpp"

namespace euler = gauss::sphere_in_cylinder;
namespace quaternion = gauss::sphere_in_cylinder_quaternion;
using physics::close_to;
using reference::number;

namespace {

struct Euler : sphere::EulerModel {
  using Forces = euler::ReactionForces<double>;
  using Residuals = euler::Residuals<double>;
  using Energy = euler::Energy<double>;
};

struct UnitQuaternion : sphere::QuaternionModel {
  using Forces = quaternion::ReactionForces<double>;
  using Residuals = quaternion::Residuals<double>;
  using Energy = quaternion::Energy<double>;
};

const reference::Json& file() {
  static const reference::Json k_file = reference::read("sphere_in_cylinder");
  return k_file;
}

/// One description with the data of the reference.
template <class Model>
struct Ball {
  using State = typename Model::template State<double>;
  using Derivative = typename Model::template Derivative<double>;
  using Parameters = typename Model::template Parameters<double>;

  static Parameters parameters() {
    Parameters p;
    p.m = number(file()["params"]["m"]);
    p.r = number(file()["params"]["r"]);
    p.R = number(file()["params"]["R"]);
    p.g = number(file()["params"]["g"]);
    p.omega_r_0 = number(file()["initial"]["omega_r"]);
    return p;
  }

  State start() const {
    State state;
    REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
    return state;
  }

  sphere::Sample observe(double t, const State& state) const {
    typename Model::Forces forces;
    return sphere::observe(t, state, inputs, prepared, forces);
  }

  auto bound() const { return gauss::integrate::bind_model<Model>(prepared, inputs); }

  double total_energy(double t, const State& state) const {
    typename Model::Energy result;
    energy(t, state, prepared, result);
    return result.total;
  }

  typename Model::Residuals residuals_of(double t, const State& state) const {
    typename Model::Residuals result;
    residuals(t, state, inputs, prepared, Derivative{}, result);
    return result;
  }

  Parameters p = parameters();
  typename Model::template Prepared<double> prepared = prepare(p);
  typename Model::template Inputs<double> inputs{};
};

double square_norm_less_1(const quaternion::State<double>& s) {
  return s.e0() * s.e0() + s.e1() * s.e1() + s.e2() * s.e2() + s.e3() * s.e3() - 1;
}
double square_norm_less_1(const euler::State<double>&) { return 0; }

}  // namespace

TEMPLATE_TEST_CASE("the ball starts as the closed form does", "", Euler, UnitQuaternion) {
  const Ball<TestType> ball;
  const sphere::Motion start = ball.observe(0, ball.start()).motion;
  const auto& initial = file()["initial"];
  CHECK(start.chi == number(initial["chi"]));
  CHECK(start.chi_dot == number(initial["chidot"]));
  CHECK(start.z == number(initial["z"]));
  CHECK(start.z_dot == Approx(number(initial["zdot"])).epsilon(1e-14));
  CHECK(start.omega[0] == Approx(number(initial["omega_r"])).epsilon(1e-13));
}

TEMPLATE_TEST_CASE("the ball follows its closed form, all three reactions included", "", Euler, UnitQuaternion) {
  const Ball<TestType> ball;
  physics::follow<TestType>(file()["expected"]["samples"], ball.prepared, ball.inputs, ball.start(),
                            [&](const auto& sample, double t, const auto& state) {
                              const sphere::Motion found = ball.observe(t, state).motion;
                              CHECK(found.chi == close_to(sample["chi"]));
                              CHECK(found.z == close_to(sample["z"]));
                              CHECK(found.z_dot == close_to(sample["vz"]));
                              CHECK(found.omega[0] == close_to(sample["omega_r"], 10));
                              CHECK(found.reaction[0] == close_to(sample["R1_normal"]));
                              CHECK(found.reaction[1] == close_to(sample["R2_friction_tangential"]));
                              CHECK(found.reaction[2] == close_to(sample["R3_friction_axial"]));
                            });
}

TEMPLATE_TEST_CASE("the ball does not fall", "", Euler, UnitQuaternion) {
  // A minute: it would be 17 km down. Its height is harmonic with the frequency nu, so the heights half a period apart have
  // the same sum always.
  const Ball<TestType> ball;
  const double half_period = 3.14159265358979324 / number(file()["expected"]["nu"]);
  const auto model = ball.bound();
  gauss::simulate::Simulation simulation(model, ball.start());
  std::vector<double> heights;
  for (int k = 0; k * half_period < 60; ++k) {
    REQUIRE(simulation.advance_to(k * half_period));
    heights.push_back(simulation.state().zeta());
  }
  const double sum = heights[0] + heights[1];
  for (std::size_t k = 1; k < heights.size(); ++k) CHECK(heights[k - 1] + heights[k] == Approx(sum).epsilon(1e-8));
}

TEMPLATE_TEST_CASE("the contact speed of the ball stays zero", "", Euler, UnitQuaternion) {
  const Ball<TestType> ball;
  const auto model = ball.bound();
  gauss::simulate::Simulation simulation(model, ball.start());
  double largest = 0;
  REQUIRE(simulation.advance_to(10, [&](double, const auto&, const auto& state) {
    largest = std::max(largest, sphere::contact_speed(state, ball.p.R, ball.p.r));
  }));
  CHECK(largest < 1e-12);
}

TEMPLATE_TEST_CASE("the energy of the ball is conserved", "", Euler, UnitQuaternion) {
  const Ball<TestType> ball;
  const auto model = ball.bound();
  gauss::simulate::Simulation simulation(model, ball.start());
  const double at_start = ball.total_energy(0, ball.start());
  // Kinetic and potential energy reach about 15 J each.
  double largest = 0;
  REQUIRE(simulation.advance_to(10, [&](double t, const auto&, const auto& state) {
    largest = std::max(largest, std::abs(ball.total_energy(t, state) - at_start));
  }));
  CHECK(largest < 1e-10);
}

TEMPLATE_TEST_CASE("no drift of the ball's constraints is left after projection, and some is without", "", Euler,
                   UnitQuaternion) {
  const Ball<TestType> ball;
  const auto model = ball.bound();
  const auto drift = [&](bool project) {
    gauss::simulate::Settings<double> settings;
    settings.tolerance = 1e-6;
    settings.project = project;
    gauss::simulate::Simulation simulation(model, ball.start(), 0.0, settings);
    double largest = 0;
    REQUIRE(simulation.advance_to(10, [&](double t, const auto&, const auto& state) {
      for (const double phi : ball.residuals_of(t, state).velocity) largest = std::max(largest, std::abs(phi));
      largest = std::max(largest, std::abs(square_norm_less_1(state)));
    }));
    return largest;
  };
  CHECK(drift(true) < 1e-12);
  CHECK(drift(false) > 1e-9);
}

TEST_CASE("Euler angles and quaternion describe the same motion and the same reactions") {
  const Ball<Euler> first;
  const Ball<UnitQuaternion> second;
  const auto first_model = first.bound();
  const auto second_model = second.bound();
  gauss::simulate::Simulation by_angles(first_model, first.start());
  gauss::simulate::Simulation by_quaternion(second_model, second.start());
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.5 * k;
    INFO("t = " << t);
    REQUIRE(by_angles.advance_to(t));
    REQUIRE(by_quaternion.advance_to(t));
    const sphere::Sample a = first.observe(t, by_angles.state());
    const sphere::Sample b = second.observe(t, by_quaternion.state());
    CHECK(sphere::angle_between(a.attitude, b.attitude) < 1e-8);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(a.motion.omega[i] == Approx(b.motion.omega[i]).margin(1e-9));
      CHECK(a.motion.reaction[i] == Approx(b.motion.reaction[i]).margin(1e-10));
    }
  }
}
