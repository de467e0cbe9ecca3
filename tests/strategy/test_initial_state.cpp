// Rates that a model leaves open: least in the mass metric among those that satisfy the constraints with the given ones.

#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "strategy/emitted_numbers.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_initial_tolerance = 1e-45;  // fifty digits, and nothing here loses any

/// At the parameters of the model file; the state of `values` is not used.
Case at_defaults(const std::string& text) {
  Case c{model_of_text("gauss: 1\nname: m\n" + text), {}, {}};
  c.values["t"] = 5;
  for (const auto& coordinate : c.model.coordinates) {
    c.values[coordinate.name.text] = 9;
    c.values[coordinate.name.text + "_dot"] = 9;
  }
  for (const auto& orientation : c.model.orientations) {
    for (const auto& name : orientation.quaternion) c.values[name.text] = 9;
    for (const auto& name : orientation.angular_velocity) c.values[name.text] = 9;
  }
  return c;
}

Vec initial(const std::string& text) {
  const Case c = at_defaults(text);
  EmittedNumbers emitted(c);
  CHECK(emitted.troubles("initial_state").empty());
  return emitted.state("initial_state");
}

const std::string k_two_particles =
    "particles:\n"
    "  light: {mass: 2, position: [a, 0, 0]}\n"
    "  heavy: {mass: 5, position: [b, 0, 0]}\n"
    "  given: {mass: 3, position: [c, 0, 0]}\n";

}  // namespace

TEST_CASE("open rates share a constraint in inverse proportion to their masses; a given rate stays") {
  const Vec state = initial("coordinates: {a: {initial: 1}, b: {initial: 2}, c: {initial: 3, initial_rate: 7}}\n" +
                            k_two_particles + "constraints: {link: {velocity: dot(a) + 2*dot(b) - dot(c)}}\n");
  // a' = s/2, b' = 2 s/5 with s (1/2 + 4/5) = 7
  const Real s = Real(70) / 13;
  CHECK(deviation(state, {1, 2, 3, s / 2, 2 * s / 5, 7}) < k_initial_tolerance);
}

TEST_CASE("a guess is the point from which the change is least") {
  const Vec state =
      initial("coordinates: {a: {initial_rate_guess: 1}, b: {initial_rate_guess: -2}, c: {initial_rate: 0}}\n" +
              k_two_particles + "constraints: {link: {velocity: dot(a) + 2*dot(b) - dot(c)}}\n");
  // a' = 1 + s/2, b' = -2 + 2 s/5 with -3 + s (1/2 + 4/5) = 0
  const Real s = Real(30) / 13;
  CHECK(deviation(state, {0, 0, 0, 1 + s / 2, -2 + 2 * s / 5, 0}) < k_initial_tolerance);
}

TEST_CASE("a held coordinate counts with its rate at t = 0, whatever the time") {
  const Vec state = initial(
      "coordinates: {a: {initial: 1}, b: {held_at: 3*t + t^2}}\n"
      "particles: {one: {mass: 2, position: [a, b, 0]}}\n"
      "constraints: {drive: {velocity: dot(a) - 2*dot(b) + 3*b}}\n");
  CHECK(deviation(state, {1, 6}) < k_initial_tolerance);
}

TEST_CASE("a constraint nonlinear in the velocities is solved to all digits from a rough guess") {
  const Vec state = initial(
      "coordinates: {x: {initial_rate: 0.6}, y: {initial_rate: -0.3}, z: {initial_rate_guess: -1}}\n"
      "particles: {load: {mass: 1.7, position: [x, y, z]}}\n"
      "constraints: {appell: {velocity: 0.64*(dot(x)^2 + dot(y)^2) - 1.21*dot(z)^2}}\n");
  const Real speed = Real(8) / 11 * sqrt(Real("0.45"));
  CHECK(deviation(state, {0, 0, 0, Real("0.6"), Real("-0.3"), -speed}) < k_initial_tolerance);
}

TEST_CASE("an initial quaternion is brought to unit length") {
  const Vec state = initial(
      "orientations:\n"
      "  q:\n"
      "    quaternion: [e0, e1, e2, e3]\n"
      "    angular_velocity: [p, q1, r]\n"
      "    frame: body\n"
      "    initial: [1, -1, 1, 1]\n"
      "    initial_angular_velocity: [1, 2, 3]\n"
      "bodies: {top: {mass: 1, inertia: [1, 2, 2], position: [0, 0, 0], orientation: q}}\n");
  const Real half = Real(1) / 2;
  CHECK(deviation(state, {half, -half, half, half, 1, 2, 3}) < k_initial_tolerance);
}
