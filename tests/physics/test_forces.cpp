// Where forces act, and what dampers damp.
#include "catch_shim.hpp"
#include "gauss/model_concept.hpp"
#include "sliding_wheel.hpp"
#include "winch.hpp"

namespace wheel = gauss::sliding_wheel;
namespace winch = gauss::winch;

TEST_CASE(
    "a force at the contact of a wheel turns the wheel, wherever on it the contact is, and its opposite pushes the "
    "slab") {
  const wheel::Parameters<double> p;
  const auto prepared = prepare(p);
  wheel::State<double> state{};
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  const wheel::Inputs<double> inputs;
  for (const double phi : {0.0, 0.7, 2.0}) {
    for (const double x : {0.0, 0.3}) {
      INFO("phi = " << phi << ", x = " << x);
      state.phi() = phi;
      state.x() = x;
      wheel::Derivative<double> derivative{};
      REQUIRE(rhs(0.0, state, inputs, prepared, derivative) == gauss::Status::ok);
      CHECK(derivative.x_ddot() == Approx(-p.F / p.m).epsilon(1e-14));
      CHECK(derivative.phi_ddot() == Approx(p.F * p.r / p.J).epsilon(1e-14));
      CHECK(derivative.s_ddot() == Approx(p.F / p.M).epsilon(1e-14));
      // No joint carries anything in the directions in which it moves.
      wheel::JointReactions<double> joints{};
      REQUIRE(joint_reactions(0.0, state, inputs, prepared, joints) == gauss::Status::ok);
      CHECK(joints.axle.moment[1] == Approx(0).margin(1e-14));
      CHECK(joints.track.force[0] == Approx(0).margin(1e-14));
      CHECK(joints.rail.force[0] == Approx(0).margin(1e-14));
    }
  }
}

TEST_CASE("a damper beside a spring damps the stretch: none where the ends follow the length at rest") {
  const auto prepared = prepare(winch::Parameters<double>{});
  const winch::Parameters<double> p;
  winch::State<double> state{};
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  const winch::Inputs<double> inputs;
  winch::Derivative<double> derivative{};
  REQUIRE(rhs(0.0, state, inputs, prepared, derivative) == gauss::Status::ok);
  CHECK(derivative.z_ddot() == Approx(0).margin(1e-11));
  CHECK(derivative.theta_ddot() == Approx(0).margin(1e-13));
  state.z_dot() += 0.1;
  state.theta_dot() += 0.1;
  REQUIRE(rhs(0.0, state, inputs, prepared, derivative) == gauss::Status::ok);
  CHECK(derivative.z_ddot() == Approx(-0.1 * p.c / p.m).epsilon(1e-10));
  CHECK(derivative.theta_ddot() == Approx(-0.1 * p.ct / p.J).epsilon(1e-10));
}
