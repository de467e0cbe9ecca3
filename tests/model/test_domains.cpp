#include "building.hpp"
#include "catch_shim.hpp"

using test::Built;
using test::with;

namespace {

/// A ball with everything that can be named: k, u, x, h (held), quaternion a..d, angular velocity wx..wz.
Built everything(const std::string& more) {
  return Built(test::k_header +
               "parameters: {k: 1}\ninputs: {u: 0}\ncoordinates: {x: {}, h: {held_at: 1}}\n"
               "orientations: {o: {quaternion: [a, b, c, d], angular_velocity: [wx, wy, wz]}}\n"
               "bodies: {ball: {mass: 1, inertia: 1, position: [x, h, 0], orientation: o}}\n" +
               more);
}

std::string constraint(const std::string& velocity) {
  return everything("constraints: {c: {velocity: " + velocity + "}}\n").codes();
}
std::string potential(const std::string& energy) {
  return everything("forces: {f: {potential: " + energy + "}}\n").codes();
}
std::string generalized(const std::string& force) {
  return everything("forces: {f: {generalized: {x: " + force + "}}}\n").codes();
}
std::string field(const std::string& component) {
  return everything("forces: {f: {uniform: [" + component + ", 0, 0]}}\n").codes();
}
std::string mass(const std::string& value) {
  return everything("particles: {p: {mass: " + value + ", position: [x, 0, 0]}}\n").codes();
}
std::string position(const std::string& value) {
  return everything("particles: {p: {mass: 1, position: [" + value + ", 0, 0]}}\n").codes();
}
std::string held(const std::string& value) {
  return Built(test::k_header + "parameters: {k: 1}\ninputs: {u: 0}\ncoordinates: {x: {}, h: {held_at: " + value +
               "}}\nparticles: {p: {mass: 1, position: [x, h, 0]}}\n")
      .codes();
}

}  // namespace

TEST_CASE("a velocity constraint takes everything but inputs") {
  CHECK(constraint("k*dot(x) + h*wx + a*t + dot(h*a)").empty());
  CHECK(constraint("dot(x)*u") == "E040");
}

TEST_CASE("a potential takes places and time, no speeds and no inputs") {
  CHECK(potential("k*x*h*a*t*pi").empty());
  CHECK(potential("wx^2") == "E040");
  CHECK(potential("x*u") == "E040");
  CHECK(potential("dot(x)^2") == "E041");
}

TEST_CASE("a generalized force takes everything") { CHECK(generalized("u*k*x*h*a*wx*dot(x)*t").empty()); }

TEST_CASE("a uniform field takes parameters and time") {
  CHECK(field("k*sin(t)").empty());
  CHECK(field("x") == "E040");
  CHECK(field("u") == "E040");
  CHECK(field("dot(x)") == "E041");
}

TEST_CASE("a mass takes parameters alone") {
  CHECK(mass("2*k").empty());
  CHECK(mass("t") == "E040");
  CHECK(mass("x") == "E040");
  CHECK(mass("u") == "E040");
}

TEST_CASE("a position takes coordinates, quaternions, parameters and time") {
  CHECK(position("x + h*a + k*t").empty());
  CHECK(position("u") == "E040");
  CHECK(position("wx") == "E040");
  CHECK(position("dot(x)") == "E041");
}

TEST_CASE("a law of a held coordinate takes parameters and time") {
  CHECK(held("k*sin(t)").empty());
  CHECK(held("x") == "E040");
  CHECK(held("u") == "E040");
}

TEST_CASE("inside dot there are no rates and no inputs") {
  CHECK(generalized("dot(x*h*a*k*t)").empty());
  CHECK(generalized("dot(u)") == "E040");
  CHECK(generalized("dot(wx)") == "E040");
  CHECK(generalized("dot(x*dot(x))") == "E041");
}

TEST_CASE("the default of an input is a plain number") {
  CHECK(Built(with("inputs: {u: 2*pi}\n")).codes().empty());
  CHECK(Built(with("parameters: {k: 1}\ninputs: {u: k}\n")).codes() == "E040");
}

TEST_CASE("an unknown name is reported once however often it is used") {
  CHECK(potential("nope + nope*nope") == "E031");
  CHECK(potential("nope + nada") == "E031 E031");
}

TEST_CASE("a section that cannot be read does not make its names unknown") {
  CHECK(
      Built(test::k_header + "parameters: [k]\ncoordinates: {x: {}}\nparticles: {p: {mass: k, position: [x, 0, 0]}}\n")
          .codes() == "E012");
  CHECK(Built(test::k_header +
              "parametres: {k: 1}\ncoordinates: {x: {}}\nparticles: {p: {mass: k, position: [x, 0, 0]}}\n")
            .codes() == "E010");
}

TEST_CASE("a constraint without a free speed constrains nothing") {
  CHECK(constraint("x - 1") == "E058");
  CHECK(constraint("dot(h)") == "E058");
  CHECK(constraint("dot(t)") == "E058");
  CHECK(constraint("wx").empty());
  CHECK(constraint("dot(a)").empty());
}
