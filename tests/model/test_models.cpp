#include <filesystem>
#include <fstream>
#include <sstream>

#include "building.hpp"
#include "catch_shim.hpp"

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

test::Built built(const std::string& name) { return test::Built(text_of(fs::path(GAUSS_SOURCE_DIR) / "models" / name), name); }

}  // namespace

TEST_CASE("every model of the repository is accepted without a finding") {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(GAUSS_SOURCE_DIR) / "models")) {
    if (entry.path().extension() != ".yaml") continue;
    const test::Built model(text_of(entry.path()), entry.path().filename().string());
    INFO(gaussgen::support::render(model.diagnostics, model.source));
    CHECK(model.codes().empty());
    ++count;
  }
  CHECK(count >= 4);
}

TEST_CASE("the ball in a cylinder is read as it is written") {
  const test::Built ball = built("sphere_in_cylinder.yaml");
  REQUIRE(ball.model);
  CHECK(ball.model->coordinates.size() == 6);
  CHECK(test::show(*ball.model->coordinates[0].held_at) == "(+ R (- r))");
  CHECK(test::show(ball.model->parameters.back().value) == "(* 2 (/ 5) m (^ r 2))");
  CHECK(ball.model->parameters.back().is_formula);
  CHECK(ball.model->parameters[2].unit == "m");
  CHECK(test::show(ball.model->constraints[0].velocity) ==
        "(+ (* (+ R (- r)) (dot chi)) (* r (dot psi)) (* r (dot phi) (cos theta)))");
  CHECK(std::get<gaussgen::model::EulerAngles>(ball.model->bodies[0].orientation).sequence == "zxz");
  CHECK(ball.model->constraints[1].about.find("minus") != std::string::npos);
}

TEST_CASE("the ball with a quaternion has seven more symbols") {
  const test::Built ball = built("sphere_in_cylinder_quaternion.yaml");
  REQUIRE(ball.model);
  CHECK(ball.model->orientations[0].frame == gaussgen::model::Frame::space);
  CHECK(test::show(*ball.model->orientations[0].initial_angular_velocity[0]) == "2");
  CHECK_FALSE(ball.model->orientations[0].initial_angular_velocity[1]);
  CHECK(ball.model->resolve("wy").index == 1);
  CHECK(ball.model->constraints[0].point);
}
