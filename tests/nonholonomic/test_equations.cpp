#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "nonholonomic/alternative_forms.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_equation_tolerance = 1e-14;

void check_equal(const Vec& a, const Vec& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    INFO("component " << i);
    CHECK(deviation(a[i], b[i]) < k_equation_tolerance);
  }
}

}  // namespace

TEST_CASE("coefficients and drift of the constraints are those of the difference quotient of φ", "[nonholonomic]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(1);
    const auto paper = nonholonomic::build_paper_system(c.model);
    PaperNumbers number(c.model, *paper, c.values);
    const Probe p = probe(c.bare);
    INFO(model.name);
    check_equal(number(paper->rows.beta_drift), p.drift);
    const Mat beta = number(paper->rows.beta);
    for (std::size_t m = 0; m < beta.size(); ++m) check_equal(beta[m], p.beta[m]);
  }
}

TEST_CASE("(3.7) with φ̇ = 0 gives the accelerations of least Z", "[nonholonomic]") {
  for (const BareModel& model : bare_models()) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const Case c = model.at(seed);
      const auto paper = nonholonomic::build_paper_system(c.model);
      PaperNumbers number(c.model, *paper, c.values);
      INFO(model.name << ", seed " << seed);
      check_equal(number(paper->accelerations), minimise(c.bare, probe(c.bare)).accelerations);
      for (const GiNaC::ex& equation : paper->motion) CHECK(abs(number(equation)) < k_equation_tolerance);
    }
  }
}

TEST_CASE("the multiplier form agrees with the elimination", "[nonholonomic]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(6);
    auto paper = nonholonomic::build_paper_system(c.model);
    const nonholonomic::MultiplierForm form = nonholonomic::multiplier_form(paper->rows, paper->system);
    PaperNumbers number(c.model, *paper, c.values);
    INFO(model.name);
    check_equal(number(form.accelerations), number(paper->accelerations));
    check_equal(number(form.lambda), number(paper->lambda));
  }
}

TEST_CASE("Appell's form (3.9)-(3.10) vanishes on the motion", "[nonholonomic]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(7);
    const auto paper = nonholonomic::build_paper_system(c.model);
    PaperNumbers number(c.model, *paper, c.values);
    INFO(model.name);
    for (const GiNaC::ex& residual : nonholonomic::appell_residual(*paper))
      CHECK(abs(number(residual)) < k_equation_tolerance);
  }
}
