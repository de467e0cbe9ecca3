// How often each place is differentiated, and what has so many derivatives.

#include "building.hpp"
#include "catch_shim.hpp"

namespace {

const std::string k_tables =
    "tables:\n"
    "  line: {of: [0, 1, 2], values: [0, 3, 4], outside: extend}\n"
    "  curve: {of: [0, 1, 2], values: [0, 3, 4], kind: spline}\n"
    "  flat: {of: [0, 1, 2], values: [0, 3, 4], kind: spline, outside: hold}\n"
    "parameters: {a: 2}\n"
    "inputs: {push: 1}\n";
const std::string k_uses = "  uses: {generalized: {x: line(x) + curve(x) + flat(x)}}\n";

std::string with_force(const std::string& force) {
  return test::Built(test::with(k_tables + "forces:\n  f: " + force + "\n" + k_uses)).codes();
}
std::string force(const std::string& q) { return with_force("{generalized: {x: \"" + q + "\"}}"); }
std::string potential(const std::string& v) { return with_force("{potential: \"" + v + "\"}"); }
std::string constraint(const std::string& phi) {
  return test::Built(test::with(k_tables + "constraints: {c: {velocity: \"" + phi + "\"}}\nforces:\n" + k_uses))
      .codes();
}
std::string position(const std::string& r) {
  return test::Built(test::k_header + test::k_x + k_tables + "particles: {p: {mass: 1, position: [x, \"" + r +
                     "\", 0]}}\nforces:\n" + k_uses)
      .codes();
}

}  // namespace

TEST_CASE("a force takes every function") {
  for (const char* q : {"sign(x)", "piecewise(x < 0, 1, dot(x))", "abs(push)", "line(t)", "flat(dot(x))"}) {
    INFO(q);
    CHECK(force(q).empty());
  }
}

TEST_CASE("a potential and a constraint take kinks and no jumps") {
  for (const char* v : {"abs(x)", "max(x, t)", "min(x, 0)^2", "line(x)", "curve(x)", "flat(x)"}) {
    INFO(v);
    CHECK(potential(v).empty());
  }
  CHECK(potential("sign(x)") == "E065");
  CHECK(potential("piecewise(x < 0, x^2, 0)") == "E065");
  CHECK(constraint("dot(x) - abs(dot(x))/2").empty());
  CHECK(constraint("dot(x) - sign(dot(x))") == "E065");
}

TEST_CASE("a position takes neither jumps nor kinks, and splines that go straight on") {
  CHECK(position("curve(x)").empty());
  for (const char* r : {"abs(x)", "max(x, 0)", "sign(t)", "line(x)", "flat(x)", "piecewise(x < 0, 1, 2)"}) {
    INFO(r);
    CHECK(position(r) == "E065");
  }
}

TEST_CASE("dot(...) takes one derivative more") {
  CHECK(force("dot(abs(x))").empty());
  CHECK(force("dot(sign(x))") == "E065");
  CHECK(constraint("dot(curve(x))").empty());
  CHECK(constraint("dot(line(x))") == "E065");
}

TEST_CASE("what stays constant during a motion may jump") {
  CHECK(position("abs(a)*x + piecewise(a < 1, x, x^2) + line(a)").empty());
  CHECK(position("piecewise(a < 1, abs(x), x^2)") == "E065");
}

TEST_CASE("all faults of an expression are found, one for each call") {
  CHECK(position("abs(x) + sign(sign(x))*min(1, x)") == "E065 E065 E065");
}

TEST_CASE("forces at places and springs take every function, equations of positions only splines that go straight on") {
  const auto tied = [](const std::string& law) {
    return test::Built(test::with(k_tables + "constraints: {c: {" + law + "}}\nforces:\n" + k_uses)).codes();
  };
  CHECK(with_force("{force: [\"sign(dot(x))\", \"piecewise(p.x < 0, 1, 2)\", line(p.x)], on: p}").empty());
  CHECK(with_force("{spring: [p, space], stiffness: \"piecewise(t < 1, 1, 2)\", length: \"2 + abs(sin(t))\"}").empty());
  CHECK(with_force("{spring: x, stiffness: sign(t), rest: line(t), damping: \"max(t, 1)\"}").empty());
  CHECK(with_force("{potential: sign(p.x)}") == "E065");
  CHECK(tied("equation: curve(x) - t").empty());
  CHECK(tied("equation: line(x) - t") == "E065");
  CHECK(tied("equation: p.x - abs(t)") == "E065");
  CHECK(tied("'distance': [p, space], is: flat(t)") == "E065");
  CHECK(tied("velocity: dot(p.x) - line(p.x)").empty());
  CHECK(tied("no_slip: p, on: space, at: [x, sign(t), 0], direction: [1, 0, abs(t)]") == "E065");
}
