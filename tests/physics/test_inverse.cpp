// Inverse dynamics: forces and inputs that make given accelerations.
#include <cmath>

#include "arm.hpp"
#include "cart_pole.hpp"
#include "catch_shim.hpp"
#include "four_bar.hpp"

namespace arm = gauss::arm;
namespace cart = gauss::cart_pole;
namespace bars = gauss::four_bar;

TEST_CASE("the torques of a two-link arm are those of its closed form") {
  const double m1 = 1.2, m2 = 0.7, l1 = 0.5, l2 = 0.4, g = 9.81;
  const auto prepared = prepare(arm::Parameters<double>());
  arm::State<double> state;
  state.shoulder() = 0.4;
  state.elbow() = -1.1;
  state.shoulder_dot() = 1.7;
  state.elbow_dot() = -2.3;
  arm::Derivative<double> wanted{};
  wanted.shoulder_ddot() = 3;
  wanted.elbow_ddot() = -5;

  // Lagrange's equations of two rods; M is symmetric, h the Coriolis factor m2 l1 l2/2 sin(elbow).
  const double c2 = std::cos(-1.1), h = m2 * l1 * l2 / 2 * std::sin(-1.1);
  const double M22 = m2 * l2 * l2 / 3, M12 = M22 + m2 * l1 * l2 / 2 * c2;
  const double M11 = m1 * l1 * l1 / 3 + m2 * l1 * l1 + M22 + m2 * l1 * l2 * c2;
  const double lower_weight = m2 * g * l2 / 2 * std::cos(0.4 - 1.1);
  const double upper_weight = (m1 / 2 + m2) * g * l1 * std::cos(0.4);
  const double shoulder = M11 * 3 - M12 * 5 - h * (2 * 1.7 * -2.3 + 2.3 * 2.3) + upper_weight + lower_weight;
  const double elbow = M12 * 3 - M22 * 5 + h * 1.7 * 1.7 + lower_weight;

  arm::InverseDynamics<double> found;
  REQUIRE(inverse_dynamics(0.0, state, {}, prepared, wanted, found) == gauss::Status::ok);
  CHECK(found.needed.shoulder_torque == Approx(shoulder).epsilon(1e-13));
  CHECK(found.needed.elbow_torque == Approx(elbow).epsilon(1e-13));
  CHECK(found.reached[0] == Approx(3).epsilon(1e-13));
  CHECK(found.reached[1] == Approx(-5).epsilon(1e-13));
  CHECK(found.missing[0] == Approx(shoulder).epsilon(1e-13));
  CHECK(found.missing[1] == Approx(elbow).epsilon(1e-13));

  arm::Inputs<double> part;
  part.shoulder_torque = 0.25 * shoulder;
  REQUIRE(inverse_dynamics(0.0, state, part, prepared, wanted, found) == gauss::Status::ok);
  CHECK(found.missing[0] == Approx(0.75 * shoulder).epsilon(1e-13));
  CHECK(found.needed.shoulder_torque == Approx(shoulder).epsilon(1e-13));
}

TEST_CASE("one input makes the acceleration along its own direction, and the others follow") {
  const double M = 2, m = 0.3, l = 0.8, g = 9.81;
  const auto prepared = prepare(cart::Parameters<double>());
  cart::State<double> state;
  state.theta() = 0.6;
  state.theta_dot() = 2;
  cart::Derivative<double> wanted{};
  wanted.x_ddot() = 4;
  cart::InverseDynamics<double> found;
  REQUIRE(inverse_dynamics(0.0, state, {}, prepared, wanted, found) == gauss::Status::ok);
  // The pole swings as in a field of -4 along x.
  const double swing = -(4 * std::cos(0.6) + g * std::sin(0.6)) / l;
  CHECK(found.reached[0] == Approx(4).epsilon(1e-13));
  CHECK(found.reached[1] == Approx(swing).epsilon(1e-13));
  CHECK(found.needed.drive == Approx((M + m) * 4 + m * l * (swing * std::cos(0.6) - 4 * std::sin(0.6))).epsilon(1e-13));
}

TEST_CASE("in a closed loop the motor's torque is found again, and missing forces do its work") {
  const auto prepared = prepare(bars::Parameters<double>());
  bars::State<double> state;
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  bars::Inputs<double> driven;
  driven.torque = 7.5;
  bars::Inputs<double> at_rest;
  at_rest.torque = 0;
  bars::Derivative<double> wanted, idle;
  REQUIRE(rhs(0.0, state, driven, prepared, wanted) == gauss::Status::ok);
  REQUIRE(rhs(0.0, state, at_rest, prepared, idle) == gauss::Status::ok);
  bars::InverseDynamics<double> found;
  REQUIRE(inverse_dynamics(0.0, state, at_rest, prepared, wanted, found) == gauss::Status::ok);
  CHECK(found.needed.torque == Approx(7.5).epsilon(1e-10));
  // Along the motion that the loop allows, whatever way the forces take.
  const double virtual_rates[] = {wanted.alpha_ddot() - idle.alpha_ddot(), wanted.beta_ddot() - idle.beta_ddot(),
                                  wanted.gamma_ddot() - idle.gamma_ddot()};
  double power = 0;
  for (int i = 0; i < 3; ++i) power += found.missing[i] * virtual_rates[i];
  CHECK(power == Approx(7.5 * virtual_rates[0]).epsilon(1e-10));
}
