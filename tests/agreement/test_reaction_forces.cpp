// Cartesian reactions: one by one where the coordinates determine them, and their sum on each body always.

#include <map>

#include "catch_shim.hpp"
#include "models.hpp"

namespace {

using gaussgen::EvaluatedValue;
using gaussgen::Mechanics;

std::map<std::string, double> forces(const gaussgen::model::Model& model) {
  Mechanics mechanics(model, {});
  std::map<std::string, double> result;
  for (const EvaluatedValue& value : gaussgen::evaluate_model(mechanics, 0, 17).values) {
    if (value.group == "reaction_forces" && value.is_defined) result[value.name] = std::stod(value.text);
  }
  return result;
}

gaussgen::model::Model parsed(const std::string& text) {
  gaussgen::support::Source source("model.yaml", text);
  gaussgen::support::Diagnostics diagnostics;
  auto model = gaussgen::read_model(source, diagnostics);
  INFO(gaussgen::support::render(diagnostics, source));
  REQUIRE(model);
  return *model;
}

bool names_one_by_one(const std::map<std::string, double>& forces, const std::string& constraint) {
  const auto found = forces.lower_bound(constraint + ".");
  return found != forces.end() && found->first.rfind(constraint + ".", 0) == 0;
}

constexpr const char* k_head = "gauss: 1\nname: m\n";

}  // namespace

TEST_CASE("single reactions on a body add up to its Newton-Euler reaction") {
  for (const char* file : {"sphere_in_cylinder", "sphere_in_cylinder_quaternion", "sphere_turntable", "appell_hamel"}) {
    INFO(file);
    const auto all = forces(agreement::load(file));
    for (const char axis : {'x', 'y', 'z'}) {
      double sum = 0;
      double total = 0;
      for (const auto& [name, value] : all) {
        const bool is_total = name.rfind("on_", 0) == 0;
        const bool is_force = name.find("force") != std::string::npos;
        if (is_force && name.back() == axis) (is_total ? total : sum) += value;
      }
      CHECK(sum == Approx(total).margin(1e-12));
    }
  }
}

TEST_CASE("a driven rod pushes each of two beads by twice m Omega dx/dt, though it is one constraint") {
  const auto all = forces(parsed(std::string(k_head) + "parameters: {m: 1, Om: 2}\n"
                                                       "coordinates:\n"
                                                       "  phi: {held_at: Om*t}\n"
                                                       "  x1: {initial: 1, initial_rate: 1}\n"
                                                       "  x2: {initial: 1, initial_rate: -1}\n"
                                                       "particles:\n"
                                                       "  one: {mass: m, position: [x1*cos(phi), x1*sin(phi), 0]}\n"
                                                       "  two: {mass: m, position: [x2*cos(phi), x2*sin(phi), 0]}\n"));
  CHECK(all.at("on_one.force.y") == Approx(4));
  CHECK(all.at("on_two.force.y") == Approx(-4));
  CHECK_FALSE(names_one_by_one(all, "phi"));
}

TEST_CASE("a rod between a cart on its rail and a bob is not split, since the rail is no coordinate") {
  const auto all =
      forces(parsed(std::string(k_head) + "coordinates:\n"
                                          "  s: {held_at: 0.8}\n"
                                          "  x: {initial_rate: 0.3}\n"
                                          "  theta: {initial: 0.6, initial_rate: 0.5}\n"
                                          "particles:\n"
                                          "  cart: {mass: 2, position: [x, 0, 0]}\n"
                                          "  bob: {mass: 1, position: [x + s*sin(theta), 0, -s*cos(theta)]}\n"
                                          "forces: {gravity: {uniform: [0, 0, -9.81]}}\n"));
  CHECK_FALSE(names_one_by_one(all, "s"));
  CHECK(all.at("on_cart.force.x") == Approx(-all.at("on_bob.force.x")));  // the rod is all that acts along x
}

TEST_CASE(
    "a pendulum on a driven pivot has its rod and pivot forces, though two held coordinates act on one particle") {
  const auto all =
      forces(parsed(std::string(k_head) + "coordinates:\n"
                                          "  u: {held_at: 0.1*sin(3*t)}\n"
                                          "  s: {held_at: 0.8}\n"
                                          "  theta: {initial: 0.5, initial_rate: 1.1}\n"
                                          "particles: {bob: {mass: 2, position: [s*sin(theta), 0, u - s*cos(theta)]}}\n"
                                          "forces: {gravity: {uniform: [0, 0, -9.81]}}\n"));
  CHECK_FALSE(names_one_by_one(all, "u"));
  // At t = 0 the pivot does not accelerate: the rod carries m (l theta'^2 + g cos theta) towards it.
  const double tension = 2 * (0.8 * 1.1 * 1.1 + 9.81 * std::cos(0.5));
  CHECK(all.at("on_bob.force.x") == Approx(-tension * std::sin(0.5)));
  CHECK(all.at("on_bob.force.z") == Approx(tension * std::cos(0.5)));
}
