// Masses and inertias that no body has.

#include <array>
#include <cmath>

#include "building.hpp"
#include "catch_shim.hpp"
#include "model/principal_moments.hpp"

using test::Built;

namespace {

std::string codes(const std::string& mass, const std::string& inertia, const std::string& parameters = "k: 1") {
  return Built("gauss: 1\nname: test\nparameters: {" + parameters +
               "}\norientations: {o: {quaternion: [a, b, c, d], angular_velocity: [p, q, r]}}\nbodies:\n  b: {mass: " +
               mass + ", inertia: " + inertia + ", position: [0, 0, 0], orientation: o}\n")
      .codes();
}

}  // namespace

TEST_CASE("principal moments are eigenvalues, smallest first") {
  const auto J = gaussgen::model::principal_moments({{{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}}});
  CHECK(J[0] == Approx(2 - std::sqrt(2.0)));
  CHECK(J[1] == Approx(2));
  CHECK(J[2] == Approx(2 + std::sqrt(2.0)));
  CHECK(gaussgen::model::principal_moments({{{3, 0, 0}, {0, 1, 0}, {0, 0, 2}}}) == std::array<double, 3>{1, 2, 3});
}

TEST_CASE("an inertia that is not positive semidefinite is refused") {
  CHECK(codes("1", "[[1, 3, 0], [3, 1, 0], [0, 0, 1]]") == "E055");
  CHECK(codes("1", "[[1, 1.01, 0], [1.01, 1, 0], [0, 0, 2]]") == "E055");
  CHECK(codes("1", "[[2, k, 0], [k, 2, 0], [0, 0, 2]]", "k: 2.5") == "E055");
  CHECK(codes("1", "[[2, k, 0], [k, 2, 0], [0, 0, 2]]", "k: 0.5").empty());
  CHECK(codes("1", "[[2, k, 0], [k, 2, 0], [0, 0, -2]]", "k: 9") == "E055");
}

TEST_CASE("moments of which one exceeds the sum of the others earn a warning, written by the axes or not") {
  CHECK(codes("1", "[1, 1, 3]") == "W063");
  CHECK(codes("1", "[0, 0, 1]") == "W063");
  CHECK(codes("1", "[[2, 1.5, 0], [1.5, 2, 0], [0, 0, 1]]") == "W063");  // 0.5, 1, 3.5
  CHECK(codes("1", "[k, 1, 1]", "k: 2.01") == "W063");
  CHECK(codes("1", "[k, 1, 1]", "k: 1.99").empty());
}

namespace {

/// Of a body with the moments [0, 0, 1] that turns as `orientation` says.
std::string planar_codes(const std::string& orientation, const std::string& inertia = "[0, 0, 1]") {
  return Built(
             "gauss: 1\nname: test\ncoordinates: {a: {}, b: {}}\nframes:\n  f: {orientation: {axis: z, angle: "
             "b}}\nbodies:\n"
             "  c: {mass: 1, frame: f, inertia: [1, 1, 2]}\n  e: {mass: 1, inertia: " +
             inertia + ", position: [0, 0, 0], orientation: " + orientation + "}\n")
      .codes();
}

}  // namespace

TEST_CASE("a body that turns about one of its axes has use for one moment, and is not warned of the others") {
  CHECK(planar_codes("{axis: z, angle: a}").empty());
  CHECK(planar_codes("{axis: -z, angle: a}").empty());
  CHECK(planar_codes("{axis: [0, 0, 3], angle: a + b}").empty());
  CHECK(planar_codes("{axis: x, angle: a}").empty());
  CHECK(planar_codes("{euler: zxz, angles: [a, b, 0]}") == "W063");
  CHECK(planar_codes("{axis: [1, 0, 1], angle: a}") == "W063");
  // Products of inertia load the bearings whatever the axis.
  CHECK(planar_codes("{axis: z, angle: a}", "[[2, 1.5, 0], [1.5, 2, 0], [0, 0, 1]]") == "W063");
  const auto on = [](const std::string& axis) {
    return Built(
               "gauss: 1\nname: test\njoints:\n  j: {type: revolute, child: p}\n  k: {type: revolute, parent: p, "
               "child: e, axis: " +
               axis + "}\nbodies:\n  e: {mass: 1, inertia: [0, 0, 1]}\n")
        .codes();
  };
  CHECK(on("z").empty());
  CHECK(on("y") == "W063");
}

TEST_CASE("flat bodies, thin rods and what was rounded to three digits are bodies") {
  CHECK(codes("1", "[1, 1, 2]").empty());
  CHECK(codes("1", "[0.1, 0.2, 0.1 + 0.2]").empty());
  CHECK(codes("1", "[0.333, 0.333, 0.6665]").empty());
  CHECK(codes("1", "[1, 1, 0]").empty());
  CHECK(codes("1", "[[1, 1, 0], [1, 1, 0], [0, 0, 2]]").empty());  // a rod along x = -y
  CHECK(codes("1", "0").empty());
}

TEST_CASE("a body without mass and inertia is warned of, one with either is not") {
  CHECK(codes("0", "0") == "W056");
  CHECK(codes("k", "[0, 0, 0]", "k: 0") == "W056");
  CHECK(codes("0", "1").empty());
  CHECK(codes("1", "0").empty());
  CHECK(codes("-1", "0") == "E055");
}
