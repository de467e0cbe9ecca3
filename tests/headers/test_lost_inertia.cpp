// What is light beside what is heavy, by each strategy: multipliers keep their digits as long as the status is ok, and which status it is
// depends on ratios alone, not on the unit of mass.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "by_multipliers/light.hpp"
#include "by_multipliers/rope.hpp"
#include "by_tree/crank.hpp"
#include "by_tree/light.hpp"
#include "by_tree/rope.hpp"
#include "catch_shim.hpp"
#include "tested_model.hpp"

GAUSS_MAKE_TESTED(by_tree::crank)
GAUSS_MAKE_TESTED(by_tree::light)
GAUSS_MAKE_TESTED(by_tree::rope)
GAUSS_MAKE_TESTED(by_multipliers::light)
GAUSS_MAKE_TESTED(by_multipliers::rope)

namespace {

using gauss::Status;
using Wide = boost::multiprecision::cpp_bin_float_100;

template <class S>
struct Motion {
  Status status;
  S acceleration[3];
  S multiplier;
};

/// Masses in units of `unit`, of which the light one is `ratio`. Binary fractions, so that every type starts from the same state.
template <class M, class S>
Motion<S> light_motion(S ratio, S unit) {
  typename M::template Parameters<S> parameters;
  parameters.M = unit;
  parameters.m = ratio * unit;
  const typename M::template State<S> state{{S(0.3125), S(0.125), S(0.4375), S(1), S(0.875), S(1)}};
  typename M::template Derivative<S> derivative{};
  typename M::template ReactionsOrNone<S> reactions{};
  const Status status = rhs_and_reactions(S(0), state, {}, prepare(parameters), derivative, reactions);
  return {status, {derivative.x_ddot(), derivative.y_ddot(), derivative.z_ddot()}, reactions.tie.multiplier};
}

// b a + drift = 0 and m a = f + b lambda for one constraint and three coordinates with a mass each.
Motion<Wide> light_answer(const Wide& ratio) {
  const Wide x = 0.3125, z = 0.4375, x_dot = 1, y_dot = 0.875, z_dot = 1;
  const Wide mass[] = {1, ratio, 1}, force[] = {1, 2 * ratio + 1, Wide(-981) / 100};
  const Wide b[] = {1 + z, -cos(x), -sin(z)};
  const Wide drift = x_dot * z_dot + y_dot * sin(x) * x_dot - z_dot * cos(z) * z_dot;
  Wide unmoved = drift, response = 0;
  for (int i = 0; i < 3; ++i) {
    unmoved += b[i] * force[i] / mass[i];
    response += b[i] * b[i] / mass[i];
  }
  Motion<Wide> answer{Status::ok, {}, -unmoved / response};
  for (int i = 0; i < 3; ++i) answer.acceleration[i] = (force[i] + b[i] * answer.multiplier) / mass[i];
  return answer;
}

template <class S>
S largest_error(const Motion<S>& motion, const Motion<Wide>& exact) {
  Wide largest = abs(Wide(motion.multiplier) / exact.multiplier - 1);
  for (int i = 0; i < 3; ++i) {
    const Wide error = abs(Wide(motion.acceleration[i]) / exact.acceleration[i] - 1);
    if (error > largest) largest = error;
  }
  return static_cast<S>(largest);
}

/// What a tree or a metric loses, the general solution finds.
template <class M, class S>
void light_is_right_or_says_so(int first_exponent, int last_exponent, S rounding) {
  for (int exponent = first_exponent; exponent >= last_exponent; exponent -= 2) {
    const S ratio = std::ldexp(S(1), exponent);
    const Motion<S> motion = light_motion<M>(ratio, S(1));
    if (motion.status != Status::ok) continue;
    INFO("mass ratio 2^" << exponent);
    CHECK(largest_error(motion, light_answer(Wide(ratio))) < rounding);
  }
}

template <class M>
void light_is_trusted_as_far_as_digits_reach() {
  for (const double ratio : {1e20, 1.0, 1e-6, 1e-12, 1e-20, 1e-30, 1e-60}) CHECK(light_motion<M>(ratio, 1.0).status == Status::ok);
  for (const double ratio : {1e-100, 1e-200}) {
    CHECK(light_motion<M>(ratio, 1.0).status == Status::singular_mass_matrix);
  }
  CHECK(light_motion<M>(1e-6F, 1.0F).status == Status::ok);
  CHECK(light_motion<M>(1e-12F, 1.0F).status == Status::ok);
  CHECK(light_motion<M>(1e-37F, 1.0F).status == Status::singular_mass_matrix);
}

struct RopeMotion {
  Status status;
  double error;  ///< largest, relative, of accelerations and multipliers
};

// s = x = y: (2 M + m) a = 3 + 0.7 with M = 1, and M a = 3 - lambda_1 (1 + a²), M a = 0.7 - lambda_2 (2 + a) along x and y. Forces stay what
// they are: in another unit of mass, accelerations are other ones.
template <class M>
RopeMotion rope_motion(double ratio, double unit) {
  typename M::template Parameters<double> parameters;
  parameters.M = unit;
  parameters.m = ratio * unit;
  const typename M::template State<double> state{{0, 0, 0, 0.25, 1, 1, 1, 0.5}};
  typename M::template Derivative<double> derivative{};
  typename M::template ReactionsOrNone<double> reactions{};
  const Status status = rhs_and_reactions(0.0, state, {}, prepare(parameters), derivative, reactions);
  const double force = 3.7 / (2 + ratio);  // M a
  double error = std::max(std::abs(reactions.first.multiplier * 1.0625 / (3 - force) - 1),
                          std::abs(reactions.second.multiplier * 2.25 / (0.7 - force) - 1));
  for (const double found : {derivative.s_ddot(), derivative.x_ddot(), derivative.y_ddot()}) {
    error = std::max(error, std::abs(found * unit / force - 1));
  }
  return {status, error};
}

// A solve loses as many digits as the ratio has, since both constraints respond to the light part alike; correcting once squares that.
template <class M>
void rope_keeps_its_digits() {
  for (int exponent = 0; exponent >= -100; --exponent) {
    const double ratio = std::ldexp(1.0, exponent);
    const RopeMotion motion = rope_motion<M>(ratio, 1.0);
    INFO("mass ratio 2^" << exponent << ": " << gauss::name(motion.status));
    if (exponent >= -38) CHECK(motion.status == Status::ok);
    const double lost = gauss::Math<double>::epsilon() / ratio;
    if (motion.status == Status::ok) CHECK(motion.error < 1e-14 + lost * lost);
  }
}

// Powers of two change no digit: a verdict that changes with them is about numbers that have a unit.
template <class Light, class Rope>
void unit_of_mass_does_not_matter() {
  for (int exponent = 40; exponent >= -130; --exponent) {
    const double ratio = std::ldexp(1.0, exponent);
    const Status light = light_motion<Light>(ratio, 1.0).status, rope = rope_motion<Rope>(ratio, 1.0).status;
    for (const int unit : {-20, 20}) {  // 1e-6 and 1e6
      INFO("mass ratio 2^" << exponent << ", masses times 2^" << unit);
      CHECK(light_motion<Light>(ratio, std::ldexp(1.0, unit)).status == light);
      CHECK(rope_motion<Rope>(ratio, std::ldexp(1.0, unit)).status == rope);
    }
  }
}

struct Held {
  Status of_rhs, of_reactions;
  double acceleration, multiplier;
};

Held crank(double inertia, double arm) {
  by_tree::crank::Parameters<double> parameters;
  parameters.K = inertia;
  parameters.r = arm;
  const auto prepared = prepare(parameters);
  const by_tree::crank::State<double> state{{0.3, 0}};
  by_tree::crank::Derivative<double> derivative{};
  by_tree::crank::Reactions<double> reactions{};
  const Status status = rhs(0.0, state, {}, prepared, derivative);
  const Status with_reactions = rhs_and_reactions(0.0, state, {}, prepared, derivative, reactions);
  return {status, with_reactions, derivative.a_ddot(), reactions.stop.multiplier};
}

}  // namespace

TEST_CASE("by each strategy, accelerations and multipliers hold at every mass ratio that status takes as ok") {
  light_is_right_or_says_so<by_tree::light::Tested, double>(40, -1000, 1e-14);
  light_is_right_or_says_so<by_tree::light::Tested, float>(10, -120, 2e-6F);
  light_is_right_or_says_so<by_multipliers::light::Tested, double>(40, -1000, 1e-14);
  light_is_right_or_says_so<by_multipliers::light::Tested, float>(10, -120, 2e-6F);
}

TEST_CASE("by each strategy, ratios of machines are ok and ratios beyond all digits are not") {
  light_is_trusted_as_far_as_digits_reach<by_tree::light::Tested>();
  light_is_trusted_as_far_as_digits_reach<by_multipliers::light::Tested>();
}

// The correction is for this: without it, multipliers lose 9 of 16 digits at a ratio of 2^-28 and the status is ok.
TEST_CASE("by each strategy, multipliers of constraints that share a light part keep their digits") {
  rope_keeps_its_digits<by_tree::rope::Tested>();
  rope_keeps_its_digits<by_multipliers::rope::Tested>();
}

TEST_CASE("by each strategy, what is too light depends on ratios alone, whatever the unit of mass") {
  unit_of_mass_does_not_matter<by_tree::light::Tested, by_tree::rope::Tested>();
  unit_of_mass_does_not_matter<by_multipliers::light::Tested, by_multipliers::rope::Tested>();
}

// The constraint says r a_ddot = 0, and bears the torque: lambda r = -T.
TEST_CASE("a row that says what an acceleration is says nothing once its coefficient is zero") {
  for (const double inertia : {0.1, 0.0}) {
    INFO("K = " << inertia);
    for (const double arm : {0.5, -0.25}) {
      const Held held = crank(inertia, arm);
      CHECK(held.of_rhs == Status::ok);
      CHECK(held.of_reactions == Status::ok);
      CHECK(held.acceleration == 0);
      CHECK(held.multiplier == Approx(-3 / arm).epsilon(1e-15));
    }
    // Nothing holds the rod then, and without inertia nothing says how it turns.
    const Status lost = inertia > 0 ? Status::dependent_constraints : Status::singular_mass_matrix;
    CHECK(crank(inertia, 0).of_rhs == lost);
    CHECK(crank(inertia, 0).of_reactions == lost);
  }
}
