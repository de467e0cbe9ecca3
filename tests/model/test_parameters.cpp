#include <vector>

#include "building.hpp"
#include "catch_shim.hpp"

using test::Built;
using test::with;

namespace {

std::vector<std::string> names(const Built& built) {
  std::vector<std::string> result;
  if (!built.model) return result;
  for (const auto& parameter : built.model->parameters) result.push_back(parameter.name.text);
  return result;
}

}  // namespace

TEST_CASE("parameters keep their order where nothing demands another") {
  CHECK(names(Built(with("parameters: {z: 1, a: 2, m: 3}\n"))) == std::vector<std::string>{"z", "a", "m"});
}

TEST_CASE("a formula comes after what it needs, and later ones stay behind") {
  CHECK(names(Built(with("parameters: {J: 2*m*r, m: 1, r: 2, g: 9}\n"))) ==
        std::vector<std::string>{"m", "r", "J", "g"});
}

TEST_CASE("the symbol table follows the new order") {
  const Built built(with("parameters: {J: 2*m, m: 1}\n"));
  REQUIRE(built.model);
  CHECK(built.model->resolve("m").index == 0);
  CHECK(built.model->resolve("J").index == 1);
}

TEST_CASE("a formula is what holds another parameter") {
  const Built built(with("parameters: {a: 2*pi, b: 2*a, c: {value: 1/3}}\n"));
  REQUIRE(built.model);
  CHECK_FALSE(built.model->parameters[0].is_formula);
  CHECK(built.model->parameters[1].is_formula);
  CHECK_FALSE(built.model->parameters[2].is_formula);
}

TEST_CASE("each cycle is reported once, without those that only depend on it") {
  CHECK(Built(with("parameters: {a: b, b: a, c: a + 1, d: d}\n")).codes() == "E042 E042");
}

TEST_CASE("a chain of many thousand parameters is no trouble") {
  std::string text = "parameters:\n";
  for (int i = 0; i < 20'000; ++i) text += "  p" + std::to_string(i) + ": p" + std::to_string(i + 1) + "\n";
  CHECK(Built(with(text + "  p20000: 1\n")).codes().empty());
}

TEST_CASE("a value that is not finite is reported once and not in what follows from it") {
  CHECK(Built(with("parameters: {a: 0, b: 1/a, c: b + 1}\n")).codes() == "E054");
  CHECK(Built(with("parameters: {a: -1, b: sqrt(a), c: b + 1}\n")).codes() == "E054");
  CHECK(Built(with("parameters: {a: 1 +, b: 1/a}\n")).codes() == "E033");
}

TEST_CASE("initial values are evaluated with the parameters") {
  CHECK(Built(test::k_header + "parameters: {a: 0}\ncoordinates: {x: {initial: 1/a}}\n" + test::k_particle).codes() ==
        "E054");
}

TEST_CASE("masses and moments of inertia may be zero but not negative") {
  CHECK(Built(test::k_header + test::k_x + "particles: {p: {mass: 0, position: [x, 0, 0]}}\n").codes() == "W056");
  CHECK(Built(test::k_header + test::k_x + "parameters: {m: 2}\nparticles: {p: {mass: 1 - m, position: [x, 0, 0]}}\n")
            .codes() == "E055");
}

TEST_CASE("a number without a map is a parameter, and an input") {
  const Built built(with("parameters: {m: 1.3}\ninputs: {u: 2, v: , w: {unit: N}}\n"));
  REQUIRE(built.model);
  CHECK(test::show(built.model->parameters[0].value) == "13/10");
  CHECK(test::show(built.model->inputs[0].value) == "2");
  CHECK(test::show(built.model->inputs[1].value) == "0");
  CHECK(test::show(built.model->inputs[2].value) == "0");
}
