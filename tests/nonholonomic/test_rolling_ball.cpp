// The paper's example against its closed form (theory, section 7).

#include <random>

#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_rolling_tolerance = 1e-14;

/// A random state that rolls: ζ̇ and ω_z from the constraints, for the quaternion model.
Case rolling_quaternion(unsigned seed) {
  Case c = case_of("sphere_in_cylinder_quaternion", seed);
  Values& v = c.values;
  v["wz"] = -(v["R"] - v["r"]) / v["r"] * v["chi_dot"];
  v["zeta_dot"] = -v["r"] * (v["wx"] * sin(v["chi"]) - v["wy"] * cos(v["chi"]));
  return c;
}

Real acceleration(const nonholonomic::PaperSystem& paper, PaperNumbers& number, const std::string& label) {
  return number(paper.chart()[paper.chart().find(label)].acceleration);
}

}  // namespace

TEST_CASE("the ball keeps χ̇ and ω_z, is held against the wall by m(R-r)χ̇², and rolls freely around", "[nonholonomic]") {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Case c = rolling_quaternion(seed);
    const auto paper = nonholonomic::build_paper_system(c.model);
    PaperNumbers number(c.model, *paper, c.values);
    const Values& v = c.values;
    CHECK(abs(acceleration(*paper, number, "chi")) < k_rolling_tolerance);
    CHECK(abs(acceleration(*paper, number, "wz")) < k_rolling_tolerance);
    const Vec lambda = number(paper->lambda);
    CHECK(abs(lambda[0]) < k_rolling_tolerance);
    const Real zeta_ddot = acceleration(*paper, number, "zeta");
    CHECK(deviation(lambda[1], v.at("m") * (zeta_ddot + v.at("g"))) < k_rolling_tolerance);
    const Real reaction = -v.at("m") * (v.at("R") - v.at("r")) * v.at("chi_dot") * v.at("chi_dot");
    CHECK(deviation(number(paper->R_x)[0], reaction) < k_rolling_tolerance);
  }
}

TEST_CASE("the ball does not fall: the height is harmonic with Ω² = χ̇² J/(J + m r²)", "[nonholonomic]") {
  // Third derivative of the height along the motion against -Ω² ζ̇, by a step of the emitted accelerations.
  const Case c = rolling_quaternion(4);
  const auto paper = nonholonomic::build_paper_system(c.model);
  const auto zeta_ddot = [&](const Real& tau) {
    Values v = c.values;
    PaperNumbers now(c.model, *paper, v);
    for (const char* name : {"wx", "wy", "wz"}) v[name] += tau * acceleration(*paper, now, name);
    v["chi"] += tau * v["chi_dot"];
    PaperNumbers then(c.model, *paper, v);
    return acceleration(*paper, then, "zeta");
  };
  const Real h("1e-15");
  const Real third = (zeta_ddot(h) - zeta_ddot(-h)) / (2 * h);
  const Values& v = c.values;
  const Real Omega_squared =
      v.at("chi_dot") * v.at("chi_dot") * v.at("J") / (v.at("J") + v.at("m") * v.at("r") * v.at("r"));
  CHECK(deviation(third, -Omega_squared * v.at("zeta_dot")) < 1e-12);
}

TEST_CASE("in the space frame the ball's metric is diag(m ρ², m, J, J, J)", "[nonholonomic]") {
  const Case c = rolling_quaternion(5);
  const auto paper = nonholonomic::build_paper_system(c.model);
  PaperNumbers number(c.model, *paper, c.values);
  const Values& v = c.values;
  const Real rho = v.at("R") - v.at("r");
  const Vec diagonal{v.at("m") * rho * rho, v.at("m"), v.at("J"), v.at("J"), v.at("J")};
  const Mat G = number(paper->system.metric.G_qq);
  for (std::size_t a = 0; a < 5; ++a) {
    for (std::size_t b = 0; b < 5; ++b) CHECK(deviation(G[a][b], a == b ? diagonal[a] : Real(0)) < k_rolling_tolerance);
  }
}

TEST_CASE("the ball's equations in Euler angles are the paper's, with the corrected sign", "[nonholonomic]") {
  const Case c = case_of("sphere_in_cylinder", 6);
  const auto paper = nonholonomic::build_paper_system(c.model);
  PaperNumbers number(c.model, *paper, c.values);
  const Values& v = c.values;
  const auto A = [&](const std::string& label) {
    return number(paper->system.invariant.A[paper->chart().find(label)]);
  };
  const Real u = v.at("psi") - v.at("chi");
  const Real lift = (A("zeta") + v.at("m") * v.at("g")) * v.at("r");
  CHECK(deviation(A("chi"), A("psi") * (v.at("R") - v.at("r")) / v.at("r")) < k_rolling_tolerance);
  CHECK(deviation(A("theta"), -lift * sin(u)) < k_rolling_tolerance);
  CHECK(deviation(A("phi"), A("psi") * cos(v.at("theta")) + lift * sin(v.at("theta")) * cos(u)) < k_rolling_tolerance);
}
