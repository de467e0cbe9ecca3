// What `gauss-gen` says of an initial state before anything is simulated, word for word.

#include <set>

#include "catch_shim.hpp"
#include "pipeline.hpp"
#include "support/error_codes.hpp"

using namespace gaussgen;

namespace {

/// The lines of `sections` begin at line 7. What they do not use is not declared.
std::string found_in(const std::string& sections, const PipelineOptions& options = {}) {
  const std::string inertia = sections.find("inertia: J") != std::string::npos ? "  J: 3\n" : "\n";
  const std::string head = "gauss: 1\nname: start\nparameters:\n  m: 2\n" + inertia + "\n";
  support::Source source("m.yaml", head + sections);
  support::Diagnostics diagnostics;
  compile(source, options, diagnostics, {});
  return support::render(diagnostics, source);
}

std::string plane(const std::string& x, const std::string& y, const std::string& constraint) {
  return "coordinates:\n  x: {" + x + "}\n  y: {" + y +
         "}\nparticles:\n  p: {mass: m, position: [x, y, 0]}\nconstraints:\n  skate: {velocity: " + constraint + "}\n";
}

}  // namespace

TEST_CASE("a start that follows from a table, whose numbers have hundreds of digits, can be emitted") {
  const std::string cam =
      "tables:\n  lift: {of: [0, pi, 2*pi], values: [0, 0.02, 0], kind: spline}\ncoordinates:\n"
      "  phi: {initial: 1.5, initial_rate: 2}\n  h: {}\nparticles:\n  p: {mass: m, position: [phi, 0, h]}\n"
      "constraints:\n  contact: {equation: h - ";
  for (const char* const height : {"m - lift(phi)", "m*lift(phi)", "sqrt(m + lift(phi))", "sin(lift(phi)*m)^2"})
    CHECK(found_in(cam + height + "}\n").empty());
}

TEST_CASE("a violated constraint is shown with its residual and the rates that could be left open") {
  CHECK(found_in(plane("initial_rate: 1", "initial_rate: 0.25", "dot(x) - dot(y)")) ==
        "m.yaml:13:21: error[E070]: the initial state violates constraint 'skate' by 0.750\n"
        " 13 |   skate: {velocity: dot(x) - dot(y)}\n"
        "    |                     ^~~~~~~~~~~~~~~\n"
        "    = hint: leave x_dot or y_dot open, and the constraint determines it\n");
}

TEST_CASE("only rates that act on the constraint at the initial state are offered") {
  CHECK_THAT(found_in(plane("initial: 0, initial_rate: 1", "initial_rate: 1", "dot(x) + x*dot(y)")),
             Catch::Contains("hint: leave x_dot open,"));
}

TEST_CASE("given rates that a constraint on them alone forbids violate it, though others are open elsewhere") {
  const std::string text = found_in(plane("initial: pi/2, initial_rate: 1", "initial: 0", "dot(x) + cos(x)*dot(y)"));
  CHECK_THAT(text, Catch::Contains("error[E070]: the initial state violates constraint 'skate' by 1.00"));
  CHECK_THAT(text, Catch::Contains("leave x_dot open"));
  CHECK_THAT(text, !Catch::Contains("W052"));
}

TEST_CASE("a rate that is left open follows from the constraint") {
  CHECK(found_in(plane("initial_rate: 1", "initial: 0", "dot(x) - dot(y)")).empty());
  CHECK(found_in(plane("initial_rate: 1/3", "initial_rate: 0.3333333333333333", "dot(x) - dot(y)")).empty());
}

TEST_CASE("open rates that a choice gave their values are shown with them") {
  const std::string plane_with = "dot(x) - 2*dot(y) - 5";
  CHECK(found_in(plane("initial: 0", "initial: 0", plane_with)) ==
        "m.yaml:8:3: warning[W059]: the constraints leave 1 of these initial rates open, and the least motion, weighed "
        "by mass, is "
        "taken: x_dot = 1.00, y_dot = -2.00\n"
        " 8 |   x: {initial: 0}\n"
        "   |   ^\n"
        "   = hint: state 1 of them by initial_rate\n");
}

TEST_CASE("nothing is said of open rates that constraints determine, that rest, or that keep their guesses") {
  CHECK(found_in(plane("initial_rate: 1", "initial: 0", "dot(x) - 2*dot(y) - 5")).empty());
  CHECK(found_in(plane("initial: 0", "initial: 0", "dot(x) - 2*dot(y)")).empty());
  CHECK(found_in(plane("initial_rate_guess: 3", "initial_rate_guess: -1", "dot(x) - 2*dot(y) - 5")).empty());
}

TEST_CASE("a rate that no constraint has, but that a mass couples to one, is a choice too") {
  const std::string cart =
      "coordinates:\n  x: {}\n  a: {initial: 1}\nparticles:\n"
      "  p: {mass: m, position: [x + sin(a), cos(a), 0]}\n  c: {mass: m, position: [x, 0, 0]}\n"
      "constraints:\n  drive: {velocity: dot(x) - 1}\n";
  CHECK_THAT(found_in(cart),
             Catch::StartsWith("m.yaml:9:3: warning[W059]") && Catch::Contains("taken: a_dot = -0.540\n"));
}

TEST_CASE("a violation is judged by the size of the terms, whatever the unit") {
  CHECK(found_in(plane("initial_rate: 1e-20", "initial_rate: 1e-20", "dot(x) - dot(y)")).empty());
  CHECK_THAT(found_in(plane("initial_rate: 1e-20", "initial_rate: 2e-20", "dot(x) - dot(y)")),
             Catch::Contains("by -1.00e-20"));
}

TEST_CASE("open rates for which the search found nothing are named") {
  CHECK_THAT(
      found_in(plane("initial_rate_guess: 1", "initial_rate_guess: 2", "dot(x)^2 + dot(y)^2 + 1")),
      Catch::Contains("[E070]") && Catch::Contains("hint: x_dot or y_dot is open: give it an initial_rate_guess"));
}

TEST_CASE("an angular velocity is offered by its name") {
  const std::string text = found_in(
      "coordinates:\n  x: {initial_rate: 1}\norientations:\n  o:\n    quaternion: [e0, e1, e2, e3]\n"
      "    angular_velocity: [wx, wy, wz]\n    initial_angular_velocity: {wx: 2}\nbodies:\n  b:\n    mass: m\n"
      "    inertia: J\n    position: [x, 0, 0]\n    orientation: o\nconstraints:\n  roll: {velocity: dot(x) - wx}\n");
  CHECK_THAT(text, Catch::Contains("hint: leave x_dot or wx open,"));
}

TEST_CASE("a constraint without a value is reported where it stands") {
  CHECK_THAT(
      found_in(plane("initial: 0, initial_rate: 0", "initial_rate: 0", "dot(x)/x + dot(y)")),
      Catch::StartsWith("m.yaml:13:28: warning[W052]: this has no value at the initial state: division by zero\n"));
}

TEST_CASE("an expression without a value is reported at the part of it that has none") {
  const std::string free = "coordinates:\n  x: {initial: -1}\nparticles:\n  p: {mass: m, position: [x, 0, 0]}\n";
  CHECK_THAT(
      found_in(free + "forces:\n  f: {potential: 2*sqrt(x)}\n"),
      Catch::StartsWith("m.yaml:12:20: warning[W052]: this has no value at the initial state: fractional power"));
  CHECK_THAT(
      found_in(free + "forces:\n  f: {generalized: {x: x*sqrt(-m)}}\n"),
      Catch::StartsWith("m.yaml:12:26: warning[W052]: this has no value at the initial state: fractional power"));
  CHECK_THAT(found_in(free + "constraints:\n  c: {velocity: asin(2*x)*dot(x)}\n"),
             Catch::StartsWith("m.yaml:12:17: warning[W052]: this has no value at the initial state: inverse sine"));
  CHECK_THAT(found_in("coordinates:\n  x: {}\n  s: {held_at: sqrt(t - 1)}\n"
                      "particles:\n  p: {mass: m, position: [x, s, 0]}\n"),
             Catch::StartsWith("m.yaml:9:16: warning[W052]: "));
}

TEST_CASE("an expression without the derivative that accelerations need is reported where it stands") {
  for (const std::string power : {"(1/2)", "(3/2)"}) {
    CHECK_THAT(
        found_in("coordinates:\n  x: {}\n  y: {}\nparticles:\n  p: {mass: m, position: [x, y + 2*x^" + power +
                 ", 0]}\n"),
        Catch::StartsWith("m.yaml:11:36: warning[W053]: there are no accelerations at the initial state: a derivative "
                          "of this has no value there: division by zero\n"));
  }
}

TEST_CASE("a state that follows from singular equations is reported by the value that is undefined") {
  CHECK_THAT(found_in(plane("initial: 0", "initial_rate: 1", "x*dot(x) + dot(y)")), Catch::Contains("[E070]"));
}

TEST_CASE("a chart that is singular at the initial state is reported") {
  CHECK_THAT(found_in("coordinates:\n  r: {initial: 0}\n  a: {}\nparticles:\n"
                      "  p: {mass: m, position: [r*cos(a), r*sin(a), 0]}\n"),
             Catch::StartsWith(
                 "m.yaml:9:3: warning[W053]: there are no accelerations at the initial state: the mass matrix is "
                 "singular, nothing determines the acceleration of 'a'\n"));
}

TEST_CASE("where a mass is zero, the mass is what the hint asks for") {
  CHECK_THAT(found_in("  z: 0\ncoordinates:\n  x: {}\nparticles:\n  p: {mass: z, position: [x, 0, 0]}\n"),
             Catch::Contains("[W053]") && Catch::Contains("hint: give 'p' a mass:"));
}

TEST_CASE("coordinates that no inertia tells apart at the initial state are named") {
  CHECK_THAT(found_in("coordinates:\n  a: {}\n  x: {}\nparticles:\n"
                      "  p: {mass: m, position: [x + sin(a), a^2, 0]}\n"),
             Catch::StartsWith("m.yaml:8:3: warning[W053]: ") &&
                 Catch::Contains("nothing tells the accelerations of a, x apart\n"));
}

TEST_CASE("constraints that follow from each other at the initial state are named") {
  const std::string more = "  again: {velocity: dot(x) - (1 + y)*dot(y)}\n";
  CHECK_THAT(found_in(plane("", "", "dot(x) - dot(y)") + more),
             Catch::StartsWith("m.yaml:14:3: warning[W057]: constraint 'again' follows from constraint 'skate' at the "
                               "initial state\n"));
  // At a state that violates them nothing is known of accelerations.
  CHECK_THAT(found_in(plane("initial_rate: 1", "initial_rate: 2", "dot(x) - dot(y)") + more),
             Catch::Contains("E070") && Catch::Contains("W057") && !Catch::Contains("E080"));
  // In motion they ask different accelerations: y would have to stay 0.
  CHECK_THAT(found_in(plane("initial_rate: 1", "initial_rate: 1", "dot(x) - dot(y)") + more),
             Catch::StartsWith("m.yaml:14:3: error[E080]: no accelerations satisfy constraints 'skate' and 'again' "
                               "together at the initial state\n"));
  CHECK_THAT(found_in(plane("initial: 0", "initial_rate: 0", "x*dot(x)")),
             Catch::Contains("warning[W057]: constraint 'skate' limits no free speed at the initial state\n"));
}

TEST_CASE("a constraint that another form of it repeats is found by its numbers") {
  const std::string sleigh =
      "coordinates:\n  x: {}\n  y: {}\n  a: {initial: 0.3}\nbodies:\n"
      "  b: {mass: m, inertia: J, position: [x + cos(a), y + sin(a), 0], orientation: {euler: zxz, angles: [a, 0, "
      "0]}}\n"
      "constraints:\n  blade: {velocity: dot(x)*sin(a) - dot(y)*cos(a)}\n";
  for (const std::string again :
       {"(dot(x)*sin(a) - dot(y)*cos(a))*cos(a)", "dot(x)*(1 - cos(2*a))/2 - dot(y)*sin(2*a)/2"}) {
    INFO(again);
    CHECK_THAT(found_in(sleigh + "  again: {velocity: '" + again + "'}\n"),
               Catch::StartsWith("m.yaml:15:3: warning[W054]: constraint 'again' follows from constraint 'blade', and "
                                 "agrees: multipliers are not unique (mobility 2)\n"));
  }
  CHECK(found_in(sleigh).empty());
}

TEST_CASE("the fewest constraints that give a redundant one are named") {
  const std::string others = "  side: {velocity: dot(y)}\n";
  CHECK_THAT(found_in(plane("", "", "dot(x) - 1") + others + "  sum: {velocity: 2*dot(x) + dot(y) - 2}\n"),
             Catch::Contains("'sum' follows from constraints 'skate' and 'side', and agrees"));
  CHECK_THAT(found_in(plane("", "", "dot(x) - 1") + others + "  again: {velocity: 3*dot(y)}\n"),
             Catch::Contains("'again' follows from constraint 'side', and agrees"));
}

TEST_CASE("constraints that ask different things of one motion are named, and nothing else is said of them") {
  const std::string model = plane("", "", "dot(x) - 1") + "  other: {velocity: dot(y) - 1}\n";
  CHECK_FALSE(Catch::Contains("E080").match(found_in(model)));
  const std::string sum = "  sum: {velocity: dot(x) + dot(y) - 3}\n";
  const std::string said =
      "no velocities satisfy constraints 'skate', 'other' and 'sum' together at the initial state\n";
  CHECK_THAT(found_in(model + sum), Catch::StartsWith("m.yaml:15:3: error[E080]: " + said) &&
                                        !Catch::Contains("E070") && !Catch::Contains("W05"));
  CHECK_THAT(found_in(model + sum + "outputs: [rhs]\n"), Catch::StartsWith("m.yaml:15:3: warning[W080]: " + said) &&
                                                             !Catch::Contains("E070") && !Catch::Contains("W05"));
  // Initial values that are wrong for both are no contradiction between them.
  CHECK_THAT(found_in(plane("initial_rate: 5", "", "dot(x) - 1") + "  again: {velocity: 2*dot(x) - 2}\n"),
             Catch::Contains("E070") && Catch::Contains("W054") && !Catch::Contains("E080"));
  // Agreement to the digits of double is agreement.
  CHECK_THAT(found_in(plane("", "", "dot(x) - 1/3") + "  again: {velocity: dot(x) - 0.3333333333333333}\n"),
             Catch::StartsWith("m.yaml:14:3: warning[W054]"));
  // What a nonlinear constraint asks is not seen from its gradient at a state that violates it.
  CHECK_THAT(found_in(plane("initial_rate: 2", "initial_rate: 0", "dot(x)^2 + dot(y)^2 - 1") +
                      "  again: {velocity: sqrt(dot(x)^2 + dot(y)^2) - 1}\n"),
             Catch::Contains("E070") && !Catch::Contains("E080"));
}

TEST_CASE("accelerations that contradict each other are seen where velocities agree") {
  const std::string model = plane("", "", "dot(x) - t") + "  other: {velocity: dot(x) - 2*t}\n";
  CHECK_THAT(found_in(model), Catch::StartsWith("m.yaml:14:3: error[E080]: no accelerations satisfy constraints "
                                                "'skate' and 'other' together at the initial state\n"));
  CHECK_THAT(found_in(model + "outputs: [rhs]\n"), Catch::StartsWith("m.yaml:14:3: warning[W080]"));
}

TEST_CASE("positions that nothing satisfies are named with what is missing, others are only not found") {
  const std::string point =
      "coordinates:\n  x: {initial_guess: 1}\n  y: {initial_guess: 1}\nparticles:\n"
      "  p: {mass: m, position: [x, y, 0]}\npoints:\n  far: {on: space, at: [4, 0, 0]}\n"
      "constraints:\n  left: {distance: [p, space], is: 1}\n";
  CHECK_THAT(found_in(point + "  right: {equation: x - 3}\n"),
             Catch::Contains("error[E080]: no position near the initial one satisfies constraints 'left' and 'right' "
                             "together: the nearest violates them by ") &&
                 !Catch::Contains("E070"));
  CHECK_THAT(found_in(point + "  right: {distance: [p, far], is: 2}\n"), Catch::Contains("[E080]"));
  CHECK_FALSE(Catch::Contains("E080").match(found_in(point + "  right: {distance: [p, far], is: 3}\n")));  // they touch
  CHECK(found_in(point + "  right: {distance: [p, far], is: 4}\n").empty());
  // A search that gets there slowly gets there.
  CHECK_FALSE(Catch::Contains("E080").match(found_in(
      "coordinates:\n  x: {initial_guess: 1}\nparticles:\n  p: {mass: m, position: [x, 0, 0]}\nconstraints:\n  c: "
      "{equation: x^4}\n")));
  // By symmetry the gradient vanishes, and yet there is a solution, from which the header starts.
  CHECK_THAT(found_in("coordinates:\n  x: {}\nparticles:\n  p: {mass: m, position: [x, 0, 0]}\nconstraints:\n  c: "
                      "{equation: x^2 - 1}\n"),
             Catch::Contains("[W068]") && Catch::Contains("'initial_guess: 1' at coordinate 'x'") && !Catch::Contains("E070"));
}

TEST_CASE("where nothing constrains, nothing is moved") {
  PipelineOptions options;
  options.assemble = true;
  const std::string particle = "particles:\n  p: {mass: m, position: [x, 0, 0]}\n";
  CHECK(found_in("coordinates:\n  x: {initial: 2, initial_rate: 1}\n" + particle, options).empty());
  CHECK(found_in("coordinates:\n  x: {held_at: 2}\n" + particle, options).empty());
}

/// What `--assemble` moves, in words.
std::vector<std::string> assembled(const std::string& text) {
  support::Source source("m.yaml", "gauss: 1\nname: assembled\nparameters: {m: 2}\n" + text);
  support::Diagnostics diagnostics;
  PipelineOptions options;
  options.assemble = true;
  const auto result = compile(source, options, diagnostics, {});
  CHECK(support::render(diagnostics, source) == "");
  return result ? result->assembled : std::vector<std::string>{"refused"};
}

TEST_CASE("a search that comes near a position where constraints are dependent says so, though it does not get there") {
  const auto bars = [](const std::string& reach) {
    return found_in(
        "joints:\n  A: {type: revolute, child: one, axis: y, initial_guess: 0.6}\n"
        "  B: {type: revolute, parent: one, child: two, at: [1, 0, 0], axis: y, initial_guess: 0.1}\n"
        "particles:\n  p: {mass: m, frame: one, centre: [1, 0, 0]}\n  q: {mass: m, frame: two, centre: [1, 0, 0]}\n"
        "constraints:\n  x: {equation: q.x - 1.6*" +
        reach + "}\n  z: {equation: q.z + 1.2*" + reach + "}\n");
  };
  CHECK_THAT(bars("1"), Catch::Contains("constraint 'z' follows from constraint 'x' at the initial state"));
  CHECK(bars("0.999").find("follows") == std::string::npos);
}

TEST_CASE("where constraints depend on each other, no mass is said to be missing") {
  const std::string text = found_in(
      "joints:\n  mast: {type: revolute, child: mast, initial: 0}\n"
      "  A: {type: revolute, parent: mast, child: a, axis: y, initial: 0.5}\n"
      "  B: {type: revolute, parent: a, child: b, at: [1, 0, 0], axis: y, initial_guess: -1}\n"
      "  S: {type: prismatic, parent: mast, child: s, axis: x, initial_guess: 1.6}\n"
      "bodies:\n  a: {mass: m, inertia: 0.1, centre: [0.5, 0, 0]}\n  b: {mass: m, inertia: 0.1, centre: [0.5, 0, 0]}\n"
      "points: {tip: {on: b, at: [1, 0, 0]}}\nconstraints: {close: {coincide: [tip, s]}}\n");
  CHECK_THAT(text, Catch::Contains("[W054]: constraint 'close_y' limits no free speed, and agrees: multipliers are not "
                                   "unique (mobility 2)"));
  CHECK_THAT(text, Catch::Contains("'in: frame' with an axis across the plane of a loop leaves a row out"));
  CHECK_THAT(text, !Catch::Contains("W053"));
}

TEST_CASE("what is given is moved only where the rest cannot satisfy the constraints") {
  const auto moved = [&](const std::string& reach) {
    std::string text =
        "coordinates:\n  a: {initial: 2, initial_rate: 3}\n  b: {initial_guess: 1}\n  c: {initial_guess: -1.5}\n"
        "particles:\n  p: {mass: m, position: [cos(a), 0, sin(a)]}\nconstraints:\n"
        "  x: {equation: cos(a) + 2*cos(b) - 1.7*cos(c) - REACH}\n  z: {equation: sin(a) + 2*sin(b) - 1.7*sin(c)}\n";
    std::string names;
    for (const std::string& value : assembled(text.replace(text.find("REACH"), 5, reach)))
      names += value.substr(0, value.find(':')) + " ";
    return names;
  };
  CHECK(moved("1.5") == "b c ");
  // Out of reach at a = 2.
  CHECK(moved("4.2").find("a ") == 0);
}

TEST_CASE("of given rates those move that have to, and it is said") {
  const std::string particle = "particles:\n  p: {mass: m, position: [x, y, z]}\nconstraints:\n";
  CHECK(assembled("coordinates: {x: {initial_rate: 5}, y: {initial_rate: 2}, z: {}}\n" + particle +
                  "  across: {velocity: dot(y)}\n  along: {velocity: dot(z) - dot(x)}\n") ==
        std::vector<std::string>{"y_dot: 2.00000000 -> 0"});
  // x stays, though only together with y and z does it satisfy all: the others can do it without.
  CHECK(assembled("coordinates: {x: {initial_rate: 1}, y: {initial_rate: 2}, z: {initial_rate: 3}}\n" + particle +
                  "  met: {velocity: dot(x) - 1}\n  missed: {velocity: dot(y) + dot(z) - 1}\n") ==
        std::vector<std::string>{"y_dot: 2.00000000 -> 0", "z_dot: 3.00000000 -> 1.00000000"});
  // Of a quaternion joint, too.
  CHECK(assembled("joints:\n  ball: {type: spherical, child: top, initial_angular_velocity: [1, 2, 3]}\n"
                  "bodies:\n  top: {mass: m, inertia: [1, 1, 1]}\nconstraints:\n  blade: {velocity: ball_wz - 2}\n") ==
        std::vector<std::string>{"ball_wz: 3.00000000 -> 2.00000000"});
}

TEST_CASE("a point at which no force is reported is named") {
  const std::string model =
      "coordinates:\n  x: {}\n  a: {}\nbodies:\n  b:\n    mass: m\n    inertia: J\n    position: [x, "
      "0, 0]\n"
      "    orientation: {euler: zxz, angles: [a, 0, 0]}\n  c:\n    mass: m\n    inertia: J\n    position: [0, x, 0]\n"
      "    orientation: {euler: zxz, angles: [2*a, 0, 0]}\nconstraints:\n  c: {velocity: dot(x) - dot(a), point: [x, "
      "0, 0]}\n";
  CHECK(found_in(model) ==
        "m.yaml:22:42: warning[W058]: the point of constraint 'c' is not used: the coordinates do not determine its "
        "force alone\n"
        " 22 |   c: {velocity: dot(x) - dot(a), point: [x, 0, 0]}\n"
        "    |                                          ^~~~~~~\n"
        "    = hint: describe every motion of the bodies that it acts on by coordinates, those that do not move by "
        "held ones\n");
  CHECK(found_in(model + "outputs: [rhs]\n").empty());
}

TEST_CASE("warnings do not keep the header back, errors do") {
  const std::string model = plane("initial_rate: 1", "initial_rate: 0", "dot(x) - dot(y)");
  const std::string head = "gauss: 1\nname: start\nparameters:\n  m: 2\n";
  support::Diagnostics errors;
  support::Source faulty("m.yaml", head + model);
  CHECK_FALSE(compile(faulty, {}, errors, {}));
  support::Source source("m.yaml", head + model + "outputs: [rhs]\n");
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
