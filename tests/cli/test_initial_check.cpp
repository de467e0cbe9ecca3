// What `gauss-gen` says of an initial state before anything is simulated, word for word.

#include <set>

#include "catch_shim.hpp"
#include "pipeline.hpp"
#include "support/error_codes.hpp"

using namespace gaussgen;

namespace {

/// The lines of `sections` begin at line 7.
std::string found_in(const std::string& sections, const PipelineOptions& options = {}) {
  const std::string head =
      "gauss: 1\nname: start\nparameters:\n  m: {value: 2, unit: kg}\n  J: {value: 3, unit: kg*m^2}\n\n";
  const support::Source source("m.yaml", head + sections);
  support::Diagnostics diagnostics;
  compile(source, options, diagnostics, {});
  return support::render(diagnostics, source);
}

std::string plane(const std::string& x, const std::string& y, const std::string& constraint) {
  return "coordinates:\n  x: {unit: m, " + x + "}\n  y: {unit: m, " + y +
         "}\nparticles:\n  p: {mass: m, position: [x, y, 0]}\nconstraints:\n  skate: {velocity: " + constraint + "}\n";
}

}  // namespace

TEST_CASE("a violated constraint is shown with its residual and the rates that could be left open") {
  CHECK(found_in(plane("initial_rate: 1", "initial_rate: 0.25", "dot(x) - dot(y)")) ==
        "m.yaml:13:21: warning[W051]: the initial state violates constraint 'skate' by 0.750\n"
        " 13 |   skate: {velocity: dot(x) - dot(y)}\n"
        "    |                     ^~~~~~~~~~~~~~~\n"
        "    = hint: leave x_dot or y_dot open, and the constraint determines it\n");
}

TEST_CASE("only rates that act on the constraint at the initial state are offered") {
  CHECK_THAT(found_in(plane("initial: 0, initial_rate: 1", "initial_rate: 1", "dot(x) + x*dot(y)")),
             Catch::Contains("hint: leave x_dot open,"));
}

TEST_CASE("a rate that is left open follows from the constraint") {
  CHECK(found_in(plane("initial_rate: 1", "initial: 0", "dot(x) - dot(y)")).empty());
  CHECK(found_in(plane("initial_rate: 1/3", "initial_rate: 0.3333333333333333", "dot(x) - dot(y)")).empty());
}

TEST_CASE("a violation is judged by the size of the terms, whatever the unit") {
  CHECK(found_in(plane("initial_rate: 1e-20", "initial_rate: 1e-20", "dot(x) - dot(y)")).empty());
  CHECK_THAT(found_in(plane("initial_rate: 1e-20", "initial_rate: 2e-20", "dot(x) - dot(y)")),
             Catch::Contains("by -1.00e-20"));
}

TEST_CASE("open rates for which the search found nothing are named") {
  CHECK_THAT(
      found_in(plane("initial_rate_guess: 1", "initial_rate_guess: 2", "dot(x)^2 + dot(y)^2 + 1")),
      Catch::Contains("[W051]") && Catch::Contains("hint: x_dot or y_dot is open: give it an initial_rate_guess"));
}

TEST_CASE("an angular velocity is offered by its name") {
  const std::string text = found_in(
      "coordinates:\n  x: {unit: m, initial_rate: 1}\norientations:\n  o:\n    quaternion: [e0, e1, e2, e3]\n"
      "    angular_velocity: [wx, wy, wz]\n    initial_angular_velocity: {wx: 2}\nbodies:\n  b:\n    mass: m\n"
      "    inertia: J\n    position: [x, 0, 0]\n    orientation: o\nconstraints:\n  roll: {velocity: dot(x) - wx}\n");
  CHECK_THAT(text, Catch::Contains("hint: leave x_dot or wx open,"));
}

TEST_CASE("a constraint without a value is reported where it stands") {
  CHECK_THAT(found_in(plane("initial: 0, initial_rate: 0", "initial_rate: 0", "dot(x)/x + dot(y)")),
             Catch::StartsWith("m.yaml:13:21: warning[W052]: constraint 'skate' has no value at the initial state: "
                               "division by zero\n"));
}

TEST_CASE("a state that follows from singular equations is reported by the value that is undefined") {
  CHECK_THAT(found_in(plane("initial: 0", "initial_rate: 1", "x*dot(x) + dot(y)")), Catch::Contains("warning[W05"));
}

TEST_CASE("a chart that is singular at the initial state is reported") {
  CHECK_THAT(found_in("coordinates:\n  r: {unit: m, initial: 0}\n  a: {unit: rad}\nparticles:\n"
                      "  p: {mass: m, position: [r*cos(a), r*sin(a), 0]}\n"),
             Catch::StartsWith("m.yaml:2:7: warning[W053]: there are no accelerations at the initial state: "));
}

TEST_CASE("warnings do not keep the header back") {
  const support::Source source("m.yaml", "gauss: 1\nname: start\nparameters:\n  m: {value: 2, unit: kg}\n" +
                                             plane("initial_rate: 1", "initial_rate: 0", "dot(x) - dot(y)"));
  support::Diagnostics diagnostics;
  const auto result = compile(source, {}, diagnostics, {});
  REQUIRE(result);
  CHECK(diagnostics.all().size() == 1);
  CHECK_FALSE(result->header.empty());
}

TEST_CASE("codes of later stages differ from those of the text") {
  std::set<std::string> seen;
  for (const support::ErrorCode& code : support::k_all_codes) CHECK(seen.insert(code.id).second);
  for (const support::ErrorCode& code : support::k_stage_codes) CHECK(seen.insert(code.id).second);
}
