// What an expression is measured in, and what of it is found.

#include <fmt/format.h>

#include "building.hpp"
#include "catch_shim.hpp"

using namespace gaussgen;
using test::Built;

namespace {

/// Names for expressions: lengths x and l, the angle a, and u, of which nobody knows the unit.
std::string model_with(const std::string& more) {
  return test::k_header +
         "coordinates: {x: {unit: m}, a: {unit: rad}}\ninputs: {F: {unit: N}}\n"
         "parameters: {m: {value: 2, unit: kg}, l: {value: 3, unit: m}, w: {value: 2, unit: rad/s}, u: 5" +
         more + "\nparticles: {p: {mass: m, position: [x*cos(a), x*sin(a), 0]}}\n";
}

/// The unit that follows for a formula over parameters; "-" for none, else the codes of what was found.
std::string unit_of(const std::string& formula) {
  const Built built(model_with(", y: '" + formula + "'}"));
  if (!built.model) return built.codes();
  for (const auto& parameter : built.model->parameters) {
    if (parameter.name.text != "y") continue;
    CHECK(parameter.unit.empty() == !parameter.dimension);
    return parameter.unit.empty() ? "-" : parameter.unit;
  }
  return "lost";
}

/// The codes that an expression over everything raises where any unit may stand.
std::string found_in(const std::string& expression) {
  return Built(model_with("}\nconstraints: {c: {velocity: '" + expression + "'}}")).codes();
}

/// The codes of a model of which everything but `u` is right, with `more`.
std::string codes(const std::string& more) { return Built(model_with("}\n" + more)).codes(); }

const std::string k_unknown = "W062";  // of u

}  // namespace

TEST_CASE("a formula has the unit that follows from its parts") {
  CHECK(unit_of("m*l^2") == "kg*m^2");
  CHECK(unit_of("2/5*m*l^2") == "kg*m^2");
  CHECK(unit_of("m*l*w^2") == "N");
  CHECK(unit_of("l*w") == "m/s");
  CHECK(unit_of("sqrt(l)") == "m^(1/2)");
  CHECK(unit_of("l^(3/2)/sqrt(l)") == "m");
  CHECK(unit_of("-l") == "m");
  CHECK(unit_of("3*l") == "m");
  CHECK(unit_of("l + 2*l - l/3") == "m");
  CHECK(unit_of("1/w") == "s/rad");
  CHECK(unit_of("l/l") == "1");
  CHECK(unit_of("l^0") == "1");
  CHECK(unit_of("sin(l/l)") == "1");
  CHECK(unit_of("atan2(l, 2*l)") == "rad");
  CHECK(unit_of("asin(1/2*l/l)") == "rad");
  CHECK(unit_of("l*exp(l/l)") == "m");
}

TEST_CASE("numbers alone have no unit of their own") {
  CHECK(unit_of("2*pi") == "-");
  CHECK(unit_of("sqrt(2)") == "-");
  CHECK(unit_of("sin(1/2) + atan2(1, 2)^2") == "-");
  CHECK(unit_of("l + 0") == "m");
  CHECK(unit_of("l - (2 - 2)") == "m");
  CHECK(unit_of("l + 2") == "E062");
  CHECK(unit_of("l + pi") == "E062");
  CHECK(unit_of("l/l + 2") == "1");
}

TEST_CASE("what has no unit fits everything") {
  CHECK(unit_of("u*l") == "-");
  CHECK(unit_of("u + l") == "m");
  CHECK(unit_of("u + 1") == "-");
  CHECK(unit_of("sin(u)*l") == "m");
  CHECK(unit_of("l^2 + u*m + l") == "E062");
}

TEST_CASE("the rate of something is per second, the time in seconds") {
  CHECK(found_in("dot(x) + l*dot(a) + l*w") == k_unknown);
  CHECK(found_in("dot(x)*t + x") == k_unknown);
  CHECK(found_in("dot(x^2) + 2*x*dot(x)") == k_unknown);
  CHECK(found_in("dot(x) + x") == "E062");
  CHECK(found_in("dot(u*x) + l*w + x*dot(u)") == k_unknown);
}

TEST_CASE("angles are numbers to sums, functions and places") {
  CHECK(found_in("dot(a) + dot(x)/l + w*(1 + a)") == k_unknown);
  CHECK(found_in("dot(x)*sin(2*a + w*t + 0.5)") == k_unknown);
}

TEST_CASE("functions take numbers") {
  for (const char* function : {"sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh"}) {
    INFO(function);
    CHECK(found_in(fmt::format("dot(x)*{}(x/l)", function)) == k_unknown);
    CHECK(found_in(fmt::format("dot(x)*{}(x)", function)) == "E063");
  }
  CHECK(found_in("dot(x)*atan2(x, l)") == k_unknown);
  CHECK(found_in("dot(x)*atan2(0, l)") == k_unknown);
  CHECK(found_in("dot(x)*atan2(u, l)") == k_unknown);
  CHECK(found_in("dot(x)*atan2(x, a)") == "E063");
  CHECK(found_in("dot(x)*atan2(1, l)") == "E063");
}

TEST_CASE("what is compared or chosen from is in one unit, which the choice has") {
  CHECK(unit_of("min(l, 2*l, 0)") == "m");
  CHECK(unit_of("max(u, l)") == "m");
  CHECK(unit_of("max(u, 1)") == "-");
  CHECK(unit_of("min(2, 3)") == "-");
  CHECK(unit_of("min(l, 1)") == "E062");
  CHECK(unit_of("max(l, m)") == "E062");
  CHECK(unit_of("abs(-l)") == "m");
  CHECK(unit_of("abs(-2)") == "-");
  CHECK(unit_of("sign(l)") == "1");
  CHECK(unit_of("sign(u)") == "1");
  CHECK(unit_of("pow(l, 2)*m") == "kg*m^2");
  CHECK(unit_of("piecewise(l > 0, l, 2*l)") == "m");
  CHECK(unit_of("piecewise(l > u, 0, l < 2*l, 0, l)") == "m");
  CHECK(unit_of("piecewise(l > 0, 1, 2)") == "-");
  CHECK(unit_of("piecewise(l > 0, l, m)") == "E062");
  CHECK(unit_of("piecewise(l > m, l, 0)") == "E062");
  CHECK(unit_of("piecewise(l > 1, l, 0)") == "E062");
  CHECK(unit_of("piecewise(l > 0, l*(l + m), l^2)") == "E062");
}

TEST_CASE("the wanted unit decides which value of a choice is wrong") {
  const Built built(model_with(", y: {value: u, unit: m}}\nforces: {f: {generalized: {x: 'min(m, x, F, l)'}}}"));
  REQUIRE(built.codes() == "E062 E062");
  CHECK(built.source.text(built.diagnostics.all()[0].span) == "m");
  CHECK(built.source.text(built.diagnostics.all()[1].span) == "x");
}

TEST_CASE("a table takes its unit and gives its unit") {
  const auto with = [](const std::string& units, const std::string& force) {
    return codes("tables: {k: {of: [0, 1], values: [0, 1]" + units + "}}\nforces: {f: {generalized: {x: '" + force +
                 "'}}}");
  };
  const std::string units = ", of_unit: m, unit: N";
  CHECK(with(units, "k(x)") == k_unknown);
  CHECK(with(units, "k(2*x - l) + k(1) + k(u)") == k_unknown);
  CHECK(with(units, "k(a)") == "E063");
  CHECK(with(units, "k(x/l)") == "E063");
  CHECK(with(units, "x*k(x)") == "E064");
  CHECK(with(units, "k(x) + x*F") == "E062");
  CHECK(with(units, "k(k(x))") == "E063");
  // What it lacks fits everything.
  CHECK(with(", unit: N", "k(a) + k(F)") == k_unknown);
  CHECK(with(", of_unit: m", "k(x) + F") == k_unknown);
  CHECK(with(", of_unit: m", "k(a) + F") == "E063");
  CHECK(with("", "k(a)*x") == k_unknown);
  CHECK(with(", of_unit: metre, unit: N", "k(a)") == "E061");
}

TEST_CASE("the unit of a table asks for the check, too") {
  const auto model = [](const std::string& units) {
    return Built(test::k_header + "tables: {k: {of: [0, 1], values: [0, 1]" + units +
                 "}}\ncoordinates: {x: {}}\nparticles: {p: {mass: 1, position: [x, 0, 0]}}\n" +
                 "forces: {f: {generalized: {x: k(t)}}}\n");
  };
  CHECK(model("").codes().empty());
  CHECK(model(", unit: N").codes() == "W062");
  CHECK(model(", of_unit: m").codes() == "E063");
}

TEST_CASE("every place wants its own unit") {
  const auto body = [](const std::string& inertia, const std::string& angle) {
    return codes("bodies: {b: {mass: m, inertia: '" + inertia + "', position: [x, 0, 0], " +
                 "orientation: {euler: zxz, angles: ['" + angle + "', 0, 0]}}}");
  };
  CHECK(body("m*l^2", "a") == k_unknown);
  CHECK(body("m*l", "a") == "E064");
  CHECK(body("m*l^2", "x") == "E064");
  CHECK(body("m*l^2", "x/l") == k_unknown);
  const auto force = [](const std::string& law) { return codes("forces: {f: {" + law + "}}"); };
  CHECK(force("uniform: [0, 0, w^2*l]") == k_unknown);
  CHECK(force("uniform: [0, 0, w*l]") == "E064");
  CHECK(force("uniform: [0, 1, -9.81]") == k_unknown);
  CHECK(force("potential: m*w^2*x^2") == k_unknown);
  CHECK(force("potential: m*w^2*x") == "E064");
  CHECK(force("generalized: {x: F, a: F*x}") == k_unknown);
  CHECK(force("generalized: {x: F*x, a: F}") == "E064 E064");
  CHECK(codes("constraints: {c: {velocity: dot(x), point: [x, a, 0]}}") == "E064");
}

TEST_CASE("numbers take the unit of their place") {
  CHECK(codes("forces: {f: {generalized: {x: 5*pi/2}}}") == k_unknown);
  CHECK(codes("forces: {f: {generalized: {x: 5*l/l}}}") == "E064");
}

TEST_CASE("a coordinate without a unit is never wrong") {
  CHECK(Built(test::k_header + "coordinates: {x: {initial: l}}\nparameters: {l: {value: 2, unit: kg}}\n"
                               "particles: {p: {mass: l, position: [x, 0, 0]}}\nforces: {f: {generalized: {x: l}}}\n")
            .codes() == k_unknown);
}

TEST_CASE("the wanted unit decides which term is wrong") {
  const Built built(model_with(", y: {value: u, unit: m}}\nforces: {f: {potential: 'm*w*x^2 - m*w*l^2 + m*w^2*x^2'}}"));
  REQUIRE(built.codes() == "E062");
  CHECK(built.source.text(built.diagnostics.all()[0].span) == "m*w*x^2");
}

TEST_CASE("one mistake is one finding") {
  CHECK(found_in("l*(dot(x) + x)*sin(x + a)") == "E062 E062");
  CHECK(found_in("sin(l*(x + a))*dot(x) + x") == "E062 E062");
  CHECK(found_in("x + x + w + w + w*w + dot(a)") == "E062 E062");
  CHECK(unit_of("l*(l + w)") == "E062");
}

TEST_CASE("a unit that cannot be read is reported once and fits everything") {
  const Built built(test::k_header +
                    "coordinates: {x: {unit: metres, initial: l}}\nparameters: {l: {value: 2, unit: kg}}\n"
                    "particles: {p: {mass: l, position: [x, 0, 0]}}\n");
  CHECK(built.codes() == "E061");
}

TEST_CASE("a formula with a unit is held against it, one without passes its own on") {
  CHECK(codes("forces: {f: {generalized: {x: F}}}") == k_unknown);
  const auto with = [](const std::string& parameters) {
    return Built(test::k_header + "coordinates: {x: {unit: m, initial: k}}\nparameters: {" + parameters +
                 "}\nparticles: {p: {mass: m, position: [x, 0, 0]}}\n")
        .codes();
  };
  // In any order, as formulas may stand.
  CHECK(with("k: 2*j, j: m*l/m, m: {value: 1, unit: kg}, l: {value: 1, unit: m}").empty());
  CHECK(with("k: 2*j, j: m*l, m: {value: 1, unit: kg}, l: {value: 1, unit: m}") == "E064");
  CHECK(with("k: {value: j, unit: m}, j: m*l, m: {value: 1, unit: kg}, l: {value: 1, unit: m}") == "E064");
}

TEST_CASE("a model without units is not checked") {
  const Built built(test::k_header +
                    "coordinates: {x: {initial: m}}\nparameters: {m: 1}\n"
                    "particles: {p: {mass: m, position: [x + m + sin(x) + t, 0, 0]}}\n");
  REQUIRE(built.model);
  CHECK(built.codes().empty());
  CHECK_FALSE(model::has_units(*built.model));
  CHECK(model::has_units(*Built(model_with("}")).model));
}

TEST_CASE("a joint gives its coordinates units; these alone ask for no check") {
  const auto arm = [](const std::string& mass, const std::string& at, const std::string& energy) {
    return Built(test::k_header + "parameters: {m: " + mass +
                 "}\njoints: {j: {type: cylindrical, child: arm, at: [0, 0, '" + at +
                 "']}}\npoints: {tip: {on: arm, at: [1, 0, 0]}}\nbodies: {b: {mass: m, inertia: 1, frame: arm}}\n" +
                 "forces: {f: {potential: '" + energy + "'}}\n");
  };
  const std::string m = "{value: 2, unit: kg}";
  CHECK(arm("2", "m", "m*tip.x + j_angle").codes().empty());
  CHECK_FALSE(model::has_units(*arm("2", "0", "m*tip.x").model));
  CHECK(arm(m, "j_shift*0.1", "0").codes().empty());
  CHECK(arm(m, "m", "0").codes() == "E064");
  CHECK(arm(m, "j_angle", "0").codes() == "E064");
  CHECK(arm(m, "0", "m*dot(tip.x)^2").codes() == "E041");
  CHECK(arm(m, "0", "m*tip.x").codes() == "E064");
  CHECK(arm(m, "0", "j_shift*(tip.x + j_angle)").codes() == "E062");
}

TEST_CASE("equations of positions are in any unit, distances in m") {
  const auto tied = [](const std::string& law) {
    return Built(test::k_header + "parameters: {m: {value: 2, unit: kg}, l: {value: 1, unit: m}}\n" +
                 "coordinates: {x: {unit: m}, y: {unit: m}}\nparticles: {p: {mass: m, position: [x, y, 0]}}\n" +
                 "constraints: {c: {" + law + "}}\n")
        .codes();
  };
  CHECK(tied("equation: x^2 + y^2 - l^2").empty());
  CHECK(tied("equation: x^2 + y^2 - l") == "E062");
  CHECK(tied("distance: [p, space], is: l").empty());
  CHECK(tied("distance: [p, space], is: 0.5").empty());
  CHECK(tied("distance: [p, space], is: m") == "E064");
}

TEST_CASE("a mistake that a shorthand repeats is found once") {
  const Built built(
      test::k_header +
      "coordinates: {s: {unit: kg}}\njoints: {j: {type: prismatic, axis: [1, 1, 1], child: cart, coordinates: s}}\n"
      "bodies: {b: {mass: 1, inertia: 1, frame: cart}}\n");
  CHECK(built.codes() == "E064");
}

TEST_CASE("sums that a shorthand makes are none of the user's") {
  const Built built(test::k_header +
                    "parameters: {m: {value: 1, unit: kg}, l: {value: 2, unit: m}}\n"
                    "joints: {j: {type: prismatic, axis: [l, 0, m], child: cart}}\n"
                    "bodies: {b: {mass: m, inertia: 1, frame: cart}}\n");
  CHECK(built.codes().empty());
}

TEST_CASE("a sum of thousands of terms is checked in no time") {
  std::string sum = "x";
  for (int i = 0; i < 3000; ++i) sum += fmt::format(" + l*{}", i);
  CHECK(codes("forces: {f: {generalized: {x: 'F*(" + sum + ")/l'}}}") == k_unknown);
}
