#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;
using nonholonomic::DependentIndex;
using symbolic::HeldIndex;

namespace {

constexpr double k_reaction_tolerance = 1e-14;

Vec raised(const Mat& E_up, const Vec& R) {
  Vec result(R.size(), 0);
  for (std::size_t i = 0; i < R.size(); ++i) {
    for (std::size_t j = 0; j < R.size(); ++j) result[i] += E_up[i][j] * R[j];
  }
  return result;
}

double largest(const Vec& a, const Vec& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, deviation(a[i], b[i]));
  return result;
}

}  // namespace

TEST_CASE("multipliers and reactions are the gradient of Gauss's function that is left at its least value",
          "[nonholonomic]") {
  for (const BareModel& model : bare_models()) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const Case c = model.at(seed);
      const auto paper = nonholonomic::build_paper_system(c.model);
      PaperNumbers number(c.model, *paper, c.values);
      const Motion motion = minimise(c.bare, probe(c.bare));
      INFO(model.name << ", seed " << seed);
      CHECK(largest(number(paper->lambda), motion.lambda) < k_reaction_tolerance);
      CHECK(largest(number(paper->R_x), motion.R_x) < k_reaction_tolerance);
    }
  }
}

TEST_CASE("(3.8) gives R^i = э^ij R_j", "[nonholonomic]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(6);
    const auto paper = nonholonomic::build_paper_system(c.model);
    PaperNumbers number(c.model, *paper, c.values);
    INFO(model.name);
    CHECK(largest(number(paper->R_x_up), raised(number(paper->system.metric.E_xx_up), number(paper->R_x))) <
          k_reaction_tolerance);
  }
}

TEST_CASE("without b^{μi}, or with the block G_ij for э_ij, the reactions of the skew models are wrong",
          "[nonholonomic]") {
  const Case c = case_of("skew_nonholonomic", 7);
  const auto paper = nonholonomic::build_paper_system(c.model);
  PaperNumbers number(c.model, *paper, c.values);
  const Vec R_up = number(paper->R_x_up);
  const gauss::System& system = paper->system;
  Vec without_b;
  for (const HeldIndex i : paper->chart().held()) {
    without_b.push_back(number(at_motion(system.compulsion.dZ_w_da_x[i], system.compulsion, system.invariant)));
  }
  CHECK(largest(without_b, R_up) > 0.1);
  CHECK(largest(raised(inverse(number(system.metric.G_xx)), number(paper->R_x)), R_up) > 0.1);
}

TEST_CASE("all b^{μi} of the ball vanish: rolling does not act on the reaction of the wall", "[nonholonomic]") {
  for (const char* name : {"sphere_in_cylinder", "sphere_in_cylinder_quaternion"}) {
    const Case c = case_of(name, 8);
    const auto paper = nonholonomic::build_paper_system(c.model);
    for (const auto& row : paper->elimination.b_x_up) {
      for (const GiNaC::ex& entry : row) CHECK(entry.is_zero());
    }
  }
  const auto skew = nonholonomic::build_paper_system(case_of("skew_nonholonomic", 8).model);
  for (const auto& row : skew->elimination.b_x_up) {
    for (const GiNaC::ex& entry : row) CHECK_FALSE(entry.is_zero());
  }
}

TEST_CASE("(3.8) is ∂Z/∂a_i + b^{μi} ∂Z/∂a^μ = 0 with the reactions in Z", "[nonholonomic]") {
  const Case c = case_of("skew_nonholonomic", 9);
  const auto paper = nonholonomic::build_paper_system(c.model);
  const gauss::System& system = paper->system;
  PaperNumbers number(c.model, *paper, c.values);
  GiNaC::exmap reactions;
  for (const HeldIndex i : paper->chart().held()) reactions[system.compulsion.R_x[i]] = paper->R_x[i];
  const auto at_reactions = [&](const GiNaC::ex& f) {
    return number(at_motion(f, system.compulsion, system.invariant).subs(reactions));
  };
  for (const HeldIndex i : paper->chart().held()) {
    Real sum = at_reactions(system.compulsion.dZ_da_x[i]);
    for (const DependentIndex mu : paper->partition.dependent.indices()) {
      sum += number(paper->elimination.b_x_up[mu][i]) *
             at_reactions(system.compulsion.dZ_da_q[paper->partition.dependent[mu]]);
    }
    CHECK(abs(sum) < k_reaction_tolerance);
  }
}
