// What `gauss-gen` says of a model once its equations are there, word for word.

#include "catch_shim.hpp"
#include "paper.hpp"
#include "pipeline.hpp"

#include "model/build.hpp"

using namespace gaussgen;

namespace {

/// The lines of `sections` begin at line 3.
support::Source source_of(const std::string& sections) { return {"m.yaml", "gauss: 1\nname: structure\n" + sections}; }

std::string found_in(const std::string& sections, const PipelineOptions& options = {}) {
  support::Source source = source_of(sections);
  support::Diagnostics diagnostics;
  const auto result = compile(source, options, diagnostics, {});
  CHECK(result.has_value() == !diagnostics.has_errors());
  return support::render(diagnostics, source);
}

std::string on_the_papers_route(const std::string& sections) {
  PipelineOptions options;
  options.route = Route::paper;
  return found_in(sections, options);
}

std::string of_derivation(const std::string& sections) {
  support::Source source = source_of(sections);
  support::Diagnostics diagnostics;
  const auto model = model::build_model(source, diagnostics);
  REQUIRE(model);
  const bool is_empty = derivation_text(*model, false, diagnostics).empty();
  CHECK(is_empty == diagnostics.has_errors());
  return support::render(diagnostics, source);
}

std::string point(const std::string& position, const std::string& more = {}) {
  return "coordinates: {x: {initial: 1}, y: {}, s: {held_at: 0}}\nparticles:\n  p: {mass: 1, position: " + position +
         "}\n" + more;
}

std::string plane(const std::string& constraints) {
  return "coordinates: {x: {initial: 1}, y: {initial: 1}}\nparticles: {p: {mass: 1, position: [x, y, "
         "0]}}\nconstraints:\n" +
         constraints;
}

const std::string k_sum =
    "coordinates: {x: {initial: 1}, y: {}}\nparticles: {p: {mass: 1, position: [x + y, 0, 0]}}\nconstraints:\n";

}  // namespace

TEST_CASE("dependent speeds are taken where they are safe everywhere; otherwise it is said what is taken instead") {
  const std::string safe = plane("  c: {velocity: dot(x) + 2*dot(y)}\nelimination: {dependent: [x]}\n");
  CHECK(found_in(safe).empty());
  const std::string skate = plane("  c: {velocity: x*dot(x) + y*dot(y)}\nelimination: {dependent: [x]}\n");
  CHECK(found_in(skate) ==
        "m.yaml:7:27: warning[W060]: emitted code does not eliminate these speeds: det b over them depends on the "
        "configuration, so it may vanish somewhere\n"
        " 7 | elimination: {dependent: [x]}\n"
        "   |                           ^\n"
        "   = hint: it takes the multiplier form; derivation and --route=paper take the choice as it is\n");
  CHECK(on_the_papers_route(skate).empty());
  CHECK_THAT(found_in(plane("  c: {velocity: x*dot(x) + dot(y)}\nelimination: {dependent: [x]}\n")),
             Catch::Contains("hint: it takes dependent speeds y;"));
}

TEST_CASE("dependent speeds that no constraint determines are refused, on both routes") {
  const std::string model = plane("  c: {velocity: x*dot(x)}\nelimination: {dependent: [y]}\n");
  CHECK_THAT(found_in(model), Catch::Contains("m.yaml:7:27: error[E059]: the constraints do not determine these"));
  CHECK_THAT(on_the_papers_route(model), Catch::Contains("error[E059]"));
  CHECK_THAT(of_derivation(model), Catch::Contains("error[E059]"));
}

TEST_CASE("a quotient that is a pole in every configuration is refused where it stands") {
  CHECK(found_in(point("[x/(y - y), y, s]")) ==
        "m.yaml:5:29: error[E053]: division by what is zero whatever the values\n"
        " 5 |   p: {mass: 1, position: [x/(y - y), y, s]}\n"
        "   |                             ^~~~~~~\n"
        "   = hint: check names and signs in it; held coordinates have their values here\n");
}

TEST_CASE("a pole that meets a zero is not forgotten") {
  for (const char* const x :
       {"x + 0*x/(y - y)", "x + 1/(y - y) - 1/(y - y)", "x + 1/(1/(y - y))", "x + log(y - y)*(x - x)", "x + (y/s)^2",
        "x + 1/sin(s)", "x + atan2(s, y - y)", "x + sqrt(s - 1)", "x + dot(x)*asin(2 + s)"}) {
    INFO(x);
    const std::string place = std::string(x).find("dot") == std::string::npos ? x : "x + asin(2 + s)";
    CHECK_THAT(found_in(point("[" + place + ", y, s]")),
               Catch::Contains("m.yaml:5:") && Catch::Contains("error[E053]"));
  }
}

TEST_CASE("a pole that numbers put in for parameters make is refused with --fold") {
  const std::string model = "parameters: {k: 1}\n" + point("[x + x/(k - 1), y, s]");
  PipelineOptions fold;
  fold.fold = true;
  CHECK_THAT(found_in(model, fold), Catch::Contains("m.yaml:6:33: error[E053]: division by what is zero"));
  CHECK_THAT(found_in(model),
             Catch::Contains("m.yaml:6:33: warning[W052]: this has no value at the initial state: division by zero"));
}

TEST_CASE("a pole of a derivative is refused, though the position has a value") {
  CHECK_THAT(found_in(point("[x + x*sqrt(s), y, s]")),
             Catch::Contains("error[E053]: the acceleration of 'x' has no value in any configuration"));
}

TEST_CASE("what a choice or a later value may save is not refused") {
  CHECK(found_in(point("[x, y + s/x, s]")).empty());
  CHECK(found_in(point("[x, y, s]", "forces: {f: {potential: sqrt(x) + log(x)}}\n")).empty());
}

TEST_CASE("numbers that multiply beyond double are refused with the name of what they make") {
  CHECK(found_in("coordinates: {x: {}}\nparticles: {p: {mass: 1e308, position: [1e308*sin(x), 0, 0]}}\n") ==
        "m.yaml:2:7: error[E054]: the numbers of the model multiply to one that double cannot hold, in G_x_x\n"
        " 2 | name: structure\n"
        "   |       ^~~~~~~~~\n"
        "   = hint: choose units in which masses, lengths and forces are of moderate size\n");
  CHECK_THAT(found_in("coordinates: {x: {}}\nparticles: {p: {mass: 1e-200, position: [1e-200*x, 0, 0]}}\n"),
             Catch::Contains("E054"));
  CHECK(found_in("coordinates: {x: {}}\nparticles: {p: {mass: 1e200, position: [1e-200*x, 0, 0]}}\n").empty());
  // As an initial value, and where only a pass multiplies them.
  PipelineOptions fold;
  fold.fold = true;
  const std::string far =
      "parameters: {m: 1e-300}\ncoordinates: {x: {initial: 1e300, initial_rate: 1}, y: {}}\nparticles: {p: {mass: m, "
      "position: [x + "
      "tanh(x*y), "
      "y, x]}}\nconstraints: {c: {velocity: dot(x)*(1 + x^2) - dot(y)}}\n";
  CHECK_THAT(found_in(far, fold), Catch::Contains("error[E054]"));
}

TEST_CASE("a constraint whose gradient vanishes in every configuration is refused") {
  CHECK(found_in(plane("  c: {velocity: dot(x) - dot(x) + x}\n")) ==
        "m.yaml:6:17: error[E058]: the constraint 'c' does not depend on any free speed: what it says of them cancels\n"
        " 6 |   c: {velocity: dot(x) - dot(x) + x}\n"
        "   |                 ^~~~~~~~~~~~~~~~~~~\n"
        "   = hint: remove it; a coordinate with a given value is declared with 'held_at'\n");
  CHECK_THAT(found_in(plane("  c: {velocity: 0*dot(x)}\n")), Catch::Contains("error[E058]"));
  CHECK_THAT(found_in(plane("  c: {velocity: (sin(2*x) - 2*sin(x)*cos(x))*dot(y)}\n")), Catch::Contains("error[E058]"));
  CHECK(found_in(plane("  c: {velocity: (sin(2*x) - 2.01*sin(x)*cos(x))*dot(y)}\n")).empty());
}

TEST_CASE("a mass that is zero by its parameter is never passed over, without a force either") {
  CHECK_THAT(found_in("parameters: {m: 0}\ncoordinates: {x: {}}\nparticles: {p: {mass: m, position: [x, 0, 0]}}\n"),
             Catch::Contains("warning[W056]: 'p' has no mass") &&
                 Catch::Contains(
                     "warning[W053]: there are no accelerations at the initial state: the mass matrix is singular"));
}

TEST_CASE("coordinates that move the same thing are fine where a constraint tells them apart") {
  CHECK(found_in(k_sum + "  c: {velocity: dot(x) - 2*dot(y)}\n").empty());
  CHECK_THAT(found_in(k_sum + "  c: {velocity: dot(x) + dot(y)}\n"),
             Catch::Contains("error[E052]: nothing determines the acceleration of 'x'"));
}

TEST_CASE("the paper's route names the coordinates for which the metric has no inverse") {
  const std::string held =
      "coordinates:\n  x: {}\n  s: {held_at: 0}\nparticles: {p: {mass: 1, position: [x + s, 0, 0]}}\n";
  const std::string expected =
      "m.yaml:4:3: error[E060]: the paper's route does not take this model: the metric G of all coordinates, held ones "
      "too, has no "
      "inverse: no body moves when 'x' and 's' change together in a certain way\n"
      " 4 |   x: {}\n"
      "   |   ^\n"
      "   = hint: every coordinate, held ones included, needs a mass that moves with it; or take the emitted route: "
      "gauss-gen "
      "without 'derivation' and without --route=paper\n";
  CHECK(on_the_papers_route(held) == expected);
  CHECK(of_derivation(held) == expected);
  CHECK(found_in(held).empty());
  const std::string idle = "coordinates:\n  x: {}\n  s: {held_at: 0}\nparticles: {p: {mass: 1, position: [x, 0, 0]}}\n";
  CHECK_THAT(of_derivation(idle),
             Catch::Contains("m.yaml:5:3: error[E060]") && Catch::Contains("no body moves with 's'"));
  CHECK_THAT(of_derivation(k_sum + "  c: {velocity: dot(x) - 2*dot(y)}\n"),
             Catch::Contains("no body moves when 'x' and 'y' change"));
}

TEST_CASE("a metric without values is judged by its pattern") {
  const std::string nowhere =
      "coordinates:\n  x: {}\n  s: {held_at: 0}\nparticles: {p: {mass: 1, position: [x + acos(2 + x^2), 0, 0]}}\n";
  CHECK_THAT(of_derivation(nowhere), Catch::Contains("error[E060]") && Catch::Contains("no body moves with 's'"));
}

TEST_CASE("a metric without values near the start is refused when its inverse is wanted") {
  const std::string huge =
      "coordinates:\n  x: {}\n  s: {held_at: 1e200}\nparticles: {p: {mass: 1, position: [x + sinh(s), 0, 0]}}\n";
  CHECK_THAT(of_derivation(huge), Catch::Contains("error[E060]"));
  CHECK_THAT(on_the_papers_route(huge), Catch::Contains("error[E060]"));
}

TEST_CASE("the paper's route names the constraints that depend on each other") {
  const std::string twice = plane("  c: {velocity: dot(x) - 2*dot(y)}\n  d: {velocity: 2*dot(x) - 4*dot(y)}\n");
  for (const std::string& text : {on_the_papers_route(twice), of_derivation(twice)}) {
    CHECK_THAT(text, Catch::Contains(
                         "m.yaml:7:3: error[E060]: the paper's route does not take this model: the constraints 'c' and "
                         "'d' depend on each other"));
  }
  // Dependent in this form only; GiNaC does not see it either.
  CHECK_THAT(of_derivation(plane(
                 "  c: {velocity: sin(2*x)*dot(x) + dot(y)}\n  d: {velocity: 2*sin(x)*cos(x)*dot(x) + dot(y)}\n")),
             Catch::Contains("the constraints 'c' and 'd' depend on each other"));
}

TEST_CASE("the paper's route is not tried on a model that no route takes") {
  CHECK_THAT(of_derivation("coordinates: {x: {}}\nparticles: {p: {mass: 0, position: [x, 0, 0]}}\n"),
             Catch::Contains("error[E052]"));
}

TEST_CASE("numbers that folding would make too large are refused before they are computed") {
  PipelineOptions fold;
  fold.fold = true;
  const std::string model = "parameters: {k: 1e300}\n" + point("['((k*x)^60)^50', y, s]");
  CHECK_THAT(found_in(model, fold), Catch::Contains("m.yaml:6:28: error[E038]: with parameters put in as numbers"));
  CHECK(found_in("parameters: {k: 1e2, n: k^3}\n" + point("['x + (1/n)^4', y, s]"), fold).empty());
}
