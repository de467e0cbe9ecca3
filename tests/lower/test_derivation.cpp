#include "lower/derivation.hpp"

#include <algorithm>

#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("the ball's derivation reads as the paper's example", "[lower]") {
  const lower::Derivation derivation = lower::derive(oracle::model_of_file("sphere_in_cylinder"));
  const std::string plain = lower::as_plain_text(derivation);
  INFO(plain);
  CHECK(contains(plain, "  rho = -r + R"));
  CHECK(contains(plain, "m: mass of the ball [kg]"));
  CHECK(contains(plain, "J = 2/5*m*r^2"));
  CHECK(contains(plain, "g_chi_chi = m*rho^2"));
  CHECK(contains(plain, "g_phi_psi = J*cos(theta)"));
  CHECK(contains(plain, "E_up_rho_rho = m^(-1)"));
  CHECK(contains(plain, "c_phi_up_psi = -cos(theta)"));
  CHECK(contains(plain, "lambda_2 = m*g + m*zeta_ddot"));
  CHECK(contains(plain, "R_rho = m*chi_dot^2*(r - R)"));
  for (const char* equation : {"(1.10)", "(1.12)", "(1.13)", "(3.6)", "(3.7)", "(3.8)"})
    CHECK(contains(plain, equation));
}

TEST_CASE("every model has a derivation in three forms, with balanced environments", "[lower]") {
  for (const char* name : {"sphere_in_cylinder", "sphere_in_cylinder_quaternion", "skew_chart", "skew_nonholonomic"}) {
    const lower::Derivation derivation = lower::derive(oracle::model_of_file(name));
    INFO(name);
    CHECK(derivation.obstacle.empty());
    const std::string latex = lower::as_latex(derivation);
    CHECK(std::count(latex.begin(), latex.end(), '{') == std::count(latex.begin(), latex.end(), '}'));
    CHECK(contains(latex, "\\end{document}"));
    CHECK(contains(lower::as_markdown(derivation), "# Equations of motion"));
    CHECK_FALSE(contains(latex, "?"));
  }
}

TEST_CASE("a user's words are escaped", "[lower]") {
  model::Model model = oracle::model_of_file("sphere_in_cylinder");
  model.about = "100% \\input{secret} $x$ <b>";
  model.coordinates[0].about = "a_b & c";
  const lower::Derivation derivation = lower::derive(model);
  CHECK(contains(lower::as_latex(derivation), "100\\% \\textbackslash{}input\\{secret\\} \\$x\\$"));
  CHECK(contains(lower::as_latex(derivation), "a\\_b \\& c"));
  CHECK(contains(lower::as_markdown(derivation), "\\<b\\>"));
}
