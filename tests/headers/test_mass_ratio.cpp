// A particle that is nearly massless follows the constraint, not its own enormous acceleration: what double finds is what
// 100 digits find, up to a ratio beyond which status says that it is not.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "catch_shim.hpp"
#include "light.hpp"
#include "only_constraints.hpp"
#include "rope.hpp"
#include "scaled.hpp"
#include "vanishing.hpp"
#include "weightless_wheel.hpp"

namespace light = gauss::light;
namespace only_constraints = gauss::only_constraints;
namespace rope = gauss::rope;
namespace scaled = gauss::scaled;
namespace vanishing = gauss::vanishing;
namespace weightless_wheel = gauss::weightless_wheel;
using gauss::Status;

namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;

template <class S>
struct Motion {
  Status status;
  S acceleration[3];
  S multiplier;
};

template <class S>
Motion<S> motion_with(const S& light_mass) {
  light::Parameters<S> parameters;
  parameters.m = light_mass;
  // Binary fractions, so that every type starts from the same state.
  const light::State<S> state{{S(0.3125), S(0.125), S(0.4375), S(1), S(0.875), S(1)}};
  light::Derivative<S> derivative{};
  light::Reactions<S> reactions{};
  const Status status = rhs_and_reactions(S(0), state, {}, prepare(parameters), derivative, reactions);
  return {status, {derivative.x_ddot(), derivative.y_ddot(), derivative.z_ddot()}, reactions.tie.multiplier};
}

template <class S>
S largest_error(const Motion<S>& motion, const Motion<Wide>& exact) {
  S largest = 0;
  for (int i = 0; i < 3; ++i) {
    const auto difference = static_cast<S>(Wide(motion.acceleration[i]) - exact.acceleration[i]);
    largest = std::max(largest, std::abs(difference / static_cast<S>(exact.acceleration[i])));
  }
  return std::max(largest, std::abs(static_cast<S>(Wide(motion.multiplier) / exact.multiplier - 1)));
}

/// Powers of two, so that the mass is the same number in every type.
template <class S>
void is_right_or_says_so(int first_exponent, int last_exponent, S rounding) {
  for (int exponent = first_exponent; exponent >= last_exponent; exponent -= 2) {
    const S mass = std::ldexp(S(1), exponent);
    const Motion<S> motion = motion_with<S>(mass);
    if (motion.status != Status::ok) continue;
    INFO("mass ratio 2^" << exponent);
    CHECK(largest_error(motion, motion_with<Wide>(Wide(mass))) < rounding);
  }
}

}  // namespace

TEST_CASE("accelerations and multipliers hold at every mass ratio that status takes as ok") {
  is_right_or_says_so<double>(40, -1000, 1e-14);
  is_right_or_says_so<float>(10, -120, 2e-6F);
}

TEST_CASE("ratios of everyday and of extreme machines are ok, ratios beyond all digits are not") {
  CHECK(motion_with(1e-6).status == Status::ok);
  CHECK(motion_with(1e-12).status == Status::ok);
  CHECK(motion_with(1e-20).status == Status::ok);
  CHECK(motion_with(1e20).status == Status::ok);
  CHECK(motion_with(1e-30).status == Status::ok);
  CHECK(motion_with(1e-60).status == Status::ok);
  CHECK(motion_with(1e-100).status == Status::singular_mass_matrix);
  CHECK(motion_with(1e-200).status == Status::singular_mass_matrix);
  CHECK(motion_with(1e-6F).status == Status::ok);
  CHECK(motion_with(1e-12F).status == Status::ok);
  CHECK(motion_with(1e-37F).status == Status::singular_mass_matrix);
}

namespace {

template <class S>
struct RopeMotion {
  Status status;
  S error;  ///< largest, relative
};

// s = x = y: (2 M + m) a = 3 + 0.7, and the second multiplier moves y alone, with M a = 0.7 - lambda k (2 + a).
template <class S>
RopeMotion<S> rope_motion(S light_mass, S k) {
  rope::Parameters<S> parameters;
  parameters.m = light_mass;
  parameters.k = k;
  const rope::State<S> state{{0, 0, 0, S(0.25), 1, 1, 1, S(0.5)}};
  rope::Derivative<S> derivative{};
  rope::Reactions<S> reactions{};
  const Status status = rhs_and_reactions(S(0), state, {}, prepare(parameters), derivative, reactions);
  const S a = S(3.7) / (2 + light_mass);
  const S lambda = (S(0.7) - a) / S(2.25);
  S error = std::abs(reactions.second.multiplier * k / lambda - 1);
  for (const S found : {derivative.s_ddot(), derivative.x_ddot(), derivative.y_ddot()}) {
    error = std::max(error, std::abs(found / a - 1));
  }
  return {status, error};
}

template <class S>
Status projected_rope(S light_mass, S& largest_rate) {
  rope::Parameters<S> parameters;
  parameters.m = light_mass;
  rope::State<S> projected{};
  const rope::State<S> apart{{0, 0, 0, S(0.25), 0, 1, -1, S(0.5)}};
  const Status status = project(S(0), apart, prepare(parameters), projected);
  largest_rate = std::max({std::abs(projected.s_dot()), std::abs(projected.x_dot()), std::abs(projected.y_dot())});
  return status;
}

}  // namespace

TEST_CASE("a light part that two constraints share is right to a part in a million, or status says that it is not") {
  for (int exponent = 0; exponent >= -100; --exponent) {
    INFO("mass ratio 2^" << exponent);
    const RopeMotion<double> motion = rope_motion(std::ldexp(1.0, exponent), 1.0);
    if (motion.status == Status::ok) CHECK(motion.error < 1e-6);
    if (exponent >= -20) CHECK(motion.error < 1e-11);
    if (exponent >= -38) CHECK(motion.status == Status::ok);
    const RopeMotion<float> single = rope_motion(std::ldexp(1.0F, exponent), 1.0F);
    if (single.status == Status::ok) CHECK(single.error < 1e-5F);
    double rate = 0;
    if (projected_rope(std::ldexp(1.0, exponent), rate) == Status::ok) CHECK(rate < 1e-6);
    if (exponent >= -13) CHECK(rate < 1e-12);
  }
}

TEST_CASE("the scale of a constraint changes its multiplier alone, unless it leaves the range of numbers") {
  for (int exponent = -500; exponent <= 500; exponent += 4) {
    INFO("k = 2^" << exponent);
    const RopeMotion<double> motion = rope_motion(0.5, std::ldexp(1.0, exponent));
    if (motion.status == Status::ok) CHECK(motion.error < 1e-12);
    if (std::abs(exponent) <= 120) CHECK(motion.status == Status::ok);
    if (std::abs(exponent) > 100) continue;
    const RopeMotion<float> single = rope_motion(0.5F, std::ldexp(1.0F, exponent));
    if (single.status == Status::ok) CHECK(single.error < 1e-5F);
    if (std::abs(exponent) <= 16) CHECK(single.status == Status::ok);
  }
}

namespace {

template <class S>
Status scaled_motion(S mass, S k, S (&found)[5]) {
  scaled::Parameters<S> parameters;
  parameters.m = mass;
  parameters.k = k;
  const auto prepared = prepare(parameters);
  scaled::State<S> state{};
  scaled::Derivative<S> derivative{};
  const Status start = initial_state(prepared, state);
  const Status motion = rhs(S(0), state, {}, prepared, derivative);
  const S values[] = {state.y_dot(), state.z_dot(), derivative.x_ddot(), derivative.y_ddot(), derivative.z_ddot()};
  std::copy_n(values, 5, found);
  return start == Status::ok ? motion : start;
}

template <class S>
void scale_does_not_matter(int largest, int always_ok, S tolerance) {
  S expected[5];
  REQUIRE(scaled_motion(S(1), S(1), expected) == Status::ok);
  for (const int mass : {-largest / 2, 0, largest / 2}) {
    for (int k = -largest; k <= largest; k += 2) {
      INFO("m = 2^" << mass << ", k = 2^" << k);
      S found[5];
      const Status status = scaled_motion(std::ldexp(S(1), mass), std::ldexp(S(1), k), found);
      if (mass == 0 && std::abs(k) <= always_ok) CHECK(status == Status::ok);
      if (status != Status::ok) continue;
      for (int i = 0; i < 5; ++i) CHECK(std::abs(found[i] / expected[i] - 1) < tolerance);
    }
  }
}

}  // namespace

TEST_CASE("nor does it together with the size of all masses: factors of a small product stay together") {
  scale_does_not_matter<double>(1000, 160, 1e-12);
  scale_does_not_matter<float>(120, 16, 2e-5F);
}

TEST_CASE("a constraint that limits nothing here is no singular mass matrix, and changes no acceleration") {
  vanishing::Derivative<double> derivative{};
  const vanishing::State<double> state{{0, 1, 0, 0}};
  CHECK(rhs(0.0, state, {}, prepare(vanishing::Parameters<double>{}), derivative) == Status::dependent_constraints);
  CHECK(derivative.x_ddot() == 0.5);
  CHECK(derivative.y_ddot() == 2);
}

// (x + y)'' = 3, and x dx - 2 y² dy = 0 differentiated once.
TEST_CASE("accelerations that only constraints determine are found although the mass matrix has no inverse") {
  const auto prepared = only_constraints::prepare(only_constraints::Parameters<double>{});
  only_constraints::State<double> state{};
  REQUIRE(initial_state(prepared, state) == Status::ok);
  const double x = state.x(), y = state.y(), u = state.x_dot(), v = state.y_dot();
  CHECK(v == Approx(x * u / (2 * y * y)).epsilon(1e-14));
  only_constraints::Derivative<double> derivative{};
  only_constraints::Reactions<double> reactions{};
  REQUIRE(rhs_and_reactions(0.0, state, {}, prepared, derivative, reactions) == Status::ok);
  const double sum = 3;
  const double y_ddot = (x * sum + u * u - 4 * y * v * v) / (x + 2 * y * y);
  CHECK(derivative.y_ddot() == Approx(y_ddot).epsilon(1e-13));
  CHECK(derivative.x_ddot() == Approx(sum - y_ddot).epsilon(1e-13));
  CHECK(std::abs(reactions.curve.multiplier) < 1e-13);
  // Nothing but the constraint moves x against y: the projection leaves x + y as it is.
  only_constraints::State<double> projected{};
  REQUIRE(project(0.0, only_constraints::State<double>{{x, y, 1, 1}}, prepared, projected) == Status::ok);
  CHECK(projected.x_dot() + projected.y_dot() == Approx(2).epsilon(1e-14));
  CHECK(std::abs(x * projected.x_dot() - 2 * y * y * projected.y_dot()) < 1e-15);
  // At x = y = 0 there is nothing to tell them apart.
  CHECK(rhs(0.0, only_constraints::State<double>{}, {}, prepared, derivative) != Status::ok);
}

// The torque on the wheel drives the cart alone: lambda r (1 + phi²) = 4 and m x_ddot = 3 m + lambda (1 + x²).
TEST_CASE("a coordinate without inertia follows from its constraint, and passes on the force that acts on it") {
  const auto prepared = weightless_wheel::prepare(weightless_wheel::Parameters<double>{});
  const weightless_wheel::State<double> state{{0.25, 0.5, 0.75, 1.25}};
  const double m = 2, r = 0.5, x = 0.25, phi = 0.5, v = 0.75, w = 1.25;
  weightless_wheel::Derivative<double> derivative{};
  weightless_wheel::Reactions<double> reactions{};
  REQUIRE(rhs_and_reactions(0.0, state, {}, prepared, derivative, reactions) == Status::ok);
  const double lambda = 4 / (r * (1 + phi * phi));
  const double x_ddot = 3 + lambda * (1 + x * x) / m;
  CHECK(reactions.rolling.multiplier == Approx(lambda).epsilon(1e-14));
  CHECK(derivative.x_ddot() == Approx(x_ddot).epsilon(1e-14));
  CHECK(derivative.phi_ddot() ==
        Approx((x_ddot * (1 + x * x) + 2 * x * v * v - 2 * r * phi * w * w) / (r * (1 + phi * phi))).epsilon(1e-14));
}
