// The slips of the paper that have physical consequences (theory, section 9), each shown to fail.

#include <fstream>

#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "nonholonomic/alternative_forms.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;
using symbolic::FreeIndex;
using symbolic::HeldIndex;

namespace {

/// The state of theory, section 9: ζ̇ and ψ̇ from the constraints.
Values state_of_section_9() {
  Values v{{"m", Real("1.3")}, {"r", Real("0.2")}, {"R", Real("1.1")}, {"g", Real("9.81")}, {"t", 0}};
  v["J"] = Real(2) / 5 * v["m"] * v["r"] * v["r"];
  v["rho"] = v["R"] - v["r"];
  const char* names[] = {"chi", "zeta", "phi", "psi", "theta", "chi_dot", "phi_dot", "theta_dot"};
  const char* numbers[] = {"0.3", "0.1", "0.5", "1.1", "0.8", "1.7", "0.6", "0.9"};
  for (std::size_t i = 0; i < 8; ++i) v[names[i]] = Real(numbers[i]);
  const Real u = v["psi"] - v["chi"];
  v["psi_dot"] = -v["phi_dot"] * cos(v["theta"]) - (v["R"] - v["r"]) / v["r"] * v["chi_dot"];
  v["zeta_dot"] = v["r"] * v["theta_dot"] * sin(u) - v["r"] * v["phi_dot"] * sin(v["theta"]) * cos(u);
  return v;
}

/// Accelerations from (3.7) and φ̇ = 0 with c multiplied by `sign`.
Vec accelerations_with(int sign, const Case& c, const nonholonomic::PaperSystem& paper) {
  PaperNumbers number(c.model, paper, c.values);
  const Mat G = number(paper.system.metric.G_qq);
  const Mat beta = number(paper.rows.beta);
  const Vec drift = number(paper.rows.beta_drift);
  const Vec bias = number(paper.system.connection.bias);
  const Vec Q = number(paper.system.Q);
  const Mat C = number(paper.elimination.c_dep);
  const std::size_t n = G.size();
  Mat matrix;
  Vec right;
  for (const auto p : paper.partition.independent.indices()) {
    const std::size_t row = paper.partition.independent[p].value;
    Vec left = G[row];
    Real known = Q[row] - bias[row];
    for (const auto mu : paper.partition.dependent.indices()) {
      const std::size_t a = paper.partition.dependent[mu].value;
      const Real factor = sign * C[mu.value][p.value];
      for (std::size_t b = 0; b < n; ++b) left[b] += factor * G[a][b];
      known += factor * (Q[a] - bias[a]);
    }
    matrix.push_back(left);
    right.push_back(known);
  }
  for (std::size_t m = 0; m < beta.size(); ++m) {
    matrix.emplace_back(beta[m].begin(), beta[m].begin() + static_cast<long>(n));
    right.push_back(-drift[m]);
  }
  return solve(matrix, right);
}

double distance(const Vec& a, const Vec& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, static_cast<double>(Real(abs(a[i] - b[i]))));
  return largest;
}

}  // namespace

TEST_CASE("printed (3.6): c = +b⁻¹b is 44 off the multiplier form, with the minus they agree",
          "[nonholonomic][slips]") {
  Case c;
  c.model = model_of_file("sphere_in_cylinder");
  c.values = state_of_section_9();
  auto paper = nonholonomic::build_paper_system(c.model);
  const auto form = nonholonomic::multiplier_form(paper->rows, paper->system);
  PaperNumbers number(c.model, *paper, c.values);
  const Vec expected = number(form.accelerations);
  const double corrected = distance(accelerations_with(1, c, *paper), expected);
  const double printed = distance(accelerations_with(-1, c, *paper), expected);
  CAPTURE(corrected, printed);
  CHECK(corrected < 1e-14);
  CHECK(printed == Approx(44).margin(1));
}

TEST_CASE("printed (3.6): with +b⁻¹b in b^{μi} the reactions of a skew model are wrong", "[nonholonomic][slips]") {
  const Case c = case_of("skew_nonholonomic", 4);
  const auto paper = nonholonomic::build_paper_system(c.model);
  PaperNumbers number(c.model, *paper, c.values);
  const gauss::System& system = paper->system;
  const Motion motion = minimise(c.bare, probe(c.bare));
  const Mat E_up = number(system.metric.E_xx_up);
  for (const HeldIndex i : paper->chart().held()) {
    Real expected = 0;
    for (std::size_t j = 0; j < motion.R_x.size(); ++j) expected += E_up[i.value][j] * motion.R_x[j];
    const Real holonomic = number(at_motion(system.compulsion.dZ_w_da_x[i], system.compulsion, system.invariant));
    const Real corrected = number(paper->R_x_up[i]);
    const Real printed = holonomic - (corrected - holonomic);
    CHECK(deviation(corrected, expected) < 1e-14);
    CHECK(deviation(printed, expected) > 0.1);
  }
}

TEST_CASE("printed second rolling constraint: the contact point slips by 0.12 m/s", "[nonholonomic][slips]") {
  const Values v = state_of_section_9();
  const Real u = v.at("psi") - v.at("chi");
  const Real last = v.at("r") * v.at("phi_dot") * sin(v.at("theta")) * cos(u);
  // v_centre + ω × r e_ρ along the vertical, ω in space by the formulas of theory, section 7.
  const Real omega_x = v.at("theta_dot") * cos(v.at("psi")) + v.at("phi_dot") * sin(v.at("theta")) * sin(v.at("psi"));
  const Real omega_y = v.at("theta_dot") * sin(v.at("psi")) - v.at("phi_dot") * sin(v.at("theta")) * cos(v.at("psi"));
  const auto contact_speed = [&](const Real& zeta_dot) -> Real {
    return zeta_dot + v.at("r") * (omega_x * sin(v.at("chi")) - omega_y * cos(v.at("chi")));
  };
  CHECK(abs(contact_speed(v.at("zeta_dot"))) < 1e-15);
  const double slip = static_cast<double>(contact_speed(v.at("zeta_dot") + 2 * last));
  CAPTURE(slip);
  CHECK(slip == Approx(0.12).margin(0.03));
}

TEST_CASE("printed R_1 = -m R χ̇² is not the reaction; -m (R - r) χ̇² is", "[nonholonomic][slips]") {
  Case c;
  c.model = model_of_file("sphere_in_cylinder");
  c.values = state_of_section_9();
  const auto paper = nonholonomic::build_paper_system(c.model);
  PaperNumbers number(c.model, *paper, c.values);
  const Values& v = c.values;
  const Real reaction = number(paper->R_x[HeldIndex{0}]);
  const Real square = v.at("m") * v.at("chi_dot") * v.at("chi_dot");
  CHECK(deviation(reaction, -square * (v.at("R") - v.at("r"))) < 1e-15);
  CHECK(deviation(reaction, -square * v.at("R")) > 0.1);
}
