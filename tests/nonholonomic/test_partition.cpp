#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

std::vector<std::string> dependent_of(const nonholonomic::PaperSystem& paper) {
  std::vector<std::string> labels;
  for (const symbolic::FreeIndex a : paper.partition.dependent) labels.push_back(paper.chart()[a].label);
  return labels;
}

constexpr const char* k_knife_edge = R"(
gauss: 1
name: knife_edge
parameters:
  m: {value: 2}
  J: {value: 3}
coordinates:
  x: {initial_rate: 1}
  y: {}
  phi: {initial: ANGLE, initial_rate: 1}
bodies:
  blade: {mass: m, inertia: J, position: [x, y, 0], orientation: {euler: zxz, angles: [phi, 0, 0]}}
constraints:
  edge: {velocity: dot(x)*sin(phi) - dot(y)*cos(phi)}
)";

std::string knife_edge(const std::string& angle, const std::string& more = "") {
  std::string text = k_knife_edge + more;
  return text.replace(text.find("ANGLE"), 5, angle);
}

}  // namespace

TEST_CASE("the ball's dependent speeds are those of the paper, with a determinant that is a parameter",
          "[nonholonomic]") {
  const auto euler = nonholonomic::build_paper_system(model_of_file("sphere_in_cylinder"));
  CHECK(dependent_of(*euler) == std::vector<std::string>{"zeta", "psi"});
  CHECK(euler->partition.is_safe);
  const auto quaternion = nonholonomic::build_paper_system(model_of_file("sphere_in_cylinder_quaternion"));
  CHECK(dependent_of(*quaternion) == std::vector<std::string>{"zeta", "wz"});
  CHECK(quaternion->partition.is_safe);
}

TEST_CASE("without a safe choice the best conditioned one at the start is taken, and marked", "[nonholonomic]") {
  const auto along_x = nonholonomic::build_paper_system(model_of_text(knife_edge("0.1")));
  CHECK(dependent_of(*along_x) == std::vector<std::string>{"y"});
  CHECK_FALSE(along_x->partition.is_safe);
  const auto along_y = nonholonomic::build_paper_system(model_of_text(knife_edge("1.5")));
  CHECK(dependent_of(*along_y) == std::vector<std::string>{"x"});
}

TEST_CASE("the user's choice of dependent speeds is kept", "[nonholonomic]") {
  const std::string choice = "elimination: {dependent: [x]}\n";
  const auto paper = nonholonomic::build_paper_system(model_of_text(knife_edge("0.1", choice)));
  CHECK(dependent_of(*paper) == std::vector<std::string>{"x"});
}

TEST_CASE("a user's choice that cannot be eliminated is noticed", "[nonholonomic]") {
  const std::string choice = "elimination: {dependent: [phi]}\n";
  CHECK_FALSE(nonholonomic::build_paper_system(model_of_text(knife_edge("0.1", choice))).has_value());
}

TEST_CASE("dependent constraints are noticed", "[nonholonomic]") {
  std::string text = knife_edge("0.1");
  text += "  again: {velocity: 2*dot(x)*sin(phi) - 2*dot(y)*cos(phi)}\n";
  CHECK_FALSE(nonholonomic::build_paper_system(model_of_text(text)).has_value());
}

TEST_CASE("every partition gives the same accelerations", "[nonholonomic]") {
  const Case c = case_of("sphere_in_cylinder", 3);
  const Vec expected = minimise(c.bare, probe(c.bare)).accelerations;
  for (const auto& [first, second] : std::vector<std::pair<std::string, std::string>>{
           {"chi", "zeta"}, {"chi", "theta"}, {"chi", "phi"}, {"psi", "theta"}, {"phi", "theta"}}) {
    model::Model model = c.model;
    model.dependent = {{first, {}}, {second, {}}};
    const auto paper = nonholonomic::build_paper_system(model);
    PaperNumbers number(model, *paper, c.values);
    const Vec accelerations = number(paper->accelerations);
    INFO(first << ", " << second);
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(deviation(accelerations[i], expected[i]) < 1e-14);
  }
}
