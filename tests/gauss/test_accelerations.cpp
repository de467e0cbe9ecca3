#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;
using symbolic::FullIndex;
using symbolic::HeldIndex;

namespace {

constexpr double k_acceleration_tolerance = 1e-15;

}  // namespace

TEST_CASE("G ÿ + bias - Q is the gradient of Gauss's function, explicit time and quaternions included", "[gauss]") {
  for (const BareModel& model : bare_models()) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Case c = model.at(seed);
      const auto paper = nonholonomic::build_paper_system(c.model);
      PaperNumbers number(c.model, *paper, c.values);
      const Vec linear = probe(c.bare).linear;
      const Vec bias = number(paper->system.connection.bias);
      const Vec Q = number(paper->system.Q);
      for (std::size_t A = 0; A < linear.size(); ++A) {
        INFO(model.name << ", component " << A);
        CHECK(deviation(bias[A] - Q[A], linear[A]) < k_acceleration_tolerance);
      }
    }
  }
}

TEST_CASE("a_i from the dual basis equals э_ij (ẍ^j + G^jA bias_A)", "[gauss]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(5);
    const auto paper = nonholonomic::build_paper_system(c.model);
    const gauss::System& system = paper->system;
    const symbolic::Chart& chart = paper->chart();
    PaperNumbers number(c.model, *paper, c.values);
    for (const HeldIndex i : chart.held()) {
      GiNaC::ex expected = 0;
      for (const HeldIndex j : chart.held()) {
        GiNaC::ex up = chart[j].acceleration;
        for (const FullIndex A : chart.all()) up += system.metric.G_up[chart.full(j)][A] * system.connection.bias[A];
        expected += system.metric.E_xx[i][j] * up;
      }
      INFO(model.name);
      CHECK(deviation(number(system.invariant.a_x[i]), number(expected)) < k_acceleration_tolerance);
    }
  }
}

TEST_CASE("without explicit time the bias is Γ of the full metric: a^α = q̈^α + Γ^α_βγ q̇^β q̇^γ with x at rest",
          "[gauss]") {
  const Case c = case_of("skew_nonholonomic", 6);
  const auto paper = nonholonomic::build_paper_system(c.model);
  const gauss::System& system = paper->system;
  const symbolic::Chart& chart = paper->chart();
  PaperNumbers number(c.model, *paper, c.values);
  for (const symbolic::FreeIndex a : chart.free()) {
    GiNaC::ex expected = chart[a].acceleration;
    for (const symbolic::FreeIndex b : chart.free()) {
      for (const symbolic::FreeIndex g : chart.free()) {
        expected += Gamma_q(system.connection, system.metric, chart, a, b, g) * chart[b].rate * chart[g].rate;
      }
    }
    CHECK(deviation(number(system.invariant.a_q_up[a]), number(expected)) < k_acceleration_tolerance);
  }
  for (const HeldIndex i : chart.held()) {
    GiNaC::ex expected = 0;
    for (const HeldIndex j : chart.held()) {
      GiNaC::ex up = chart[j].acceleration;
      for (const FullIndex A : chart.all()) {
        for (const FullIndex B : chart.all()) {
          up += Gamma_y(system.connection, system.metric, chart, chart.full(j), A, B) * chart[A].rate * chart[B].rate;
        }
      }
      expected += system.metric.E_xx[i][j] * up;
    }
    CHECK(deviation(number(system.invariant.a_x[i]), number(expected)) < k_acceleration_tolerance);
  }
}

namespace {

/// The same motion with nothing but inertia in it: what is linear in Z is then bias_A.
BareSystem without_forces(BareSystem bare) {
  bare.field = {0, 0, 0};
  bare.potential = nullptr;
  bare.generalized.clear();
  return bare;
}

/// inverse · covector over the first `size` components
Vec raised(const Mat& metric, const Vec& covector, std::size_t size) {
  Mat block;
  for (std::size_t i = 0; i < size; ++i)
    block.emplace_back(metric[i].begin(), metric[i].begin() + static_cast<long>(size));
  return solve(block, Vec(covector.begin(), covector.begin() + static_cast<long>(size)));
}

}  // namespace

TEST_CASE("Γ^α_βγ q̇^β q̇^γ and Γ^A_BC ẏ^B ẏ^C are the raised inertia of bare points on a straight line of the chart",
          "[gauss]") {
  for (const char* name : {"sphere_in_cylinder", "skew_nonholonomic"}) {
    const Case c = case_of(name, 7);
    const auto paper = nonholonomic::build_paper_system(c.model);
    const gauss::System& system = paper->system;
    const symbolic::Chart& chart = paper->chart();
    PaperNumbers number(c.model, *paper, c.values);
    const Probe p = probe(without_forces(c.bare));
    const Vec induced = raised(p.G, p.linear, c.bare.free_count);
    const Vec full = raised(p.G, p.linear, c.bare.y.size());
    INFO(name);
    for (const symbolic::FreeIndex a : chart.free()) {
      GiNaC::ex sum = 0;
      for (const symbolic::FreeIndex b : chart.free()) {
        for (const symbolic::FreeIndex g : chart.free()) {
          sum += Gamma_q(system.connection, system.metric, chart, a, b, g) * chart[b].rate * chart[g].rate;
        }
      }
      CHECK(deviation(number(sum), induced[a.value]) < k_acceleration_tolerance);
    }
    for (const FullIndex A : chart.all()) {
      GiNaC::ex sum = 0;
      for (const FullIndex B : chart.all()) {
        for (const FullIndex C : chart.all()) {
          sum += Gamma_y(system.connection, system.metric, chart, A, B, C) * chart[B].rate * chart[C].rate;
        }
      }
      CHECK(deviation(number(sum), full[A.value]) < k_acceleration_tolerance);
    }
  }
  // The ball's Euler angles are curved: with Γ = 0 the above would show nothing.
  const Case ball = case_of("sphere_in_cylinder", 7);
  const Probe p = probe(without_forces(ball.bare));
  Real largest = 0;
  for (const Real& component : raised(p.G, p.linear, ball.bare.free_count))
    largest = std::max(largest, Real(abs(component)));
  CHECK(largest > 0.1);
}

TEST_CASE("A_i and Q_i are not the a_i and F_i of (1.13) in a skew chart", "[gauss]") {
  const Case c = case_of("skew_chart", 1);
  const auto paper = nonholonomic::build_paper_system(c.model);
  const symbolic::Chart& chart = paper->chart();
  PaperNumbers number(c.model, *paper, c.values);
  const HeldIndex s{0};
  const gauss::InvariantAccelerations& invariant = paper->system.invariant;
  CHECK(deviation(number(invariant.A[chart.full(s)]), number(invariant.a_x[s])) > 0.01);
  CHECK(deviation(number(paper->system.Q[chart.full(s)]), number(invariant.F_x[s])) > 0.01);
}
