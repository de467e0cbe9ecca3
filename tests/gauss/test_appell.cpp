#include "catch_shim.hpp"
#include "gauss/appell.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

TEST_CASE("the derivative of Gibbs and Appell's function by ÿ^A is the covariant acceleration A_A", "[gauss]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(11);
    const auto paper = nonholonomic::build_paper_system(c.model);
    const symbolic::Chart& chart = paper->chart();
    PaperNumbers number(c.model, *paper, c.values);
    const GiNaC::ex S = gauss::gibbs_appell(paper->system.bodies, chart);
    for (const symbolic::FullIndex A : chart.all()) {
      INFO(model.name << ", " << chart[A].label);
      CHECK(deviation(number(S.diff(chart[A].acceleration)), number(paper->system.invariant.A[A])) < 1e-15);
    }
  }
}
