#include <random>

#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;
using symbolic::FreeIndex;
using symbolic::HeldIndex;

namespace {

constexpr double k_compulsion_tolerance = 1e-15;

Real quadratic(const Probe& p, const Vec& y) {
  Real Z = p.rest;
  for (std::size_t i = 0; i < y.size(); ++i) {
    Z += p.linear[i] * y[i];
    for (std::size_t j = 0; j < y.size(); ++j) Z += p.G[i][j] * y[i] * y[j] / 2;
  }
  return Z;
}

/// Accelerations that have nothing to do with the motion.
GiNaC::ex other_acceleration(FreeIndex a) { return GiNaC::numeric(static_cast<long>(a.value) + 1, 7); }

}  // namespace

TEST_CASE("Z_w of (1.13) is Gauss's function up to a term free of accelerations", "[gauss]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(8);
    const auto paper = nonholonomic::build_paper_system(c.model);
    PaperNumbers number(c.model, *paper, c.values);
    const Probe p = probe(c.bare);
    Vec moving = minimise(c.bare, p).accelerations;
    Vec other;
    GiNaC::exmap replaced;
    for (const FreeIndex a : paper->chart().free()) {
      replaced[paper->chart()[a].acceleration] = other_acceleration(a);
      other.push_back(Real(a.value + 1) / 7);
    }
    moving.insert(moving.end(), c.bare.held_acceleration.begin(), c.bare.held_acceleration.end());
    other.insert(other.end(), c.bare.held_acceleration.begin(), c.bare.held_acceleration.end());
    const gauss::System& system = paper->system;
    const GiNaC::ex Z_w = at_motion(system.compulsion.Z_w, system.compulsion, system.invariant);
    const Real at_motion_value = number(Z_w);
    const Real at_other = number(Z_w.subs(replaced));
    INFO(model.name);
    CHECK(deviation(at_other - at_motion_value, quadratic(p, other) - quadratic(p, moving)) < k_compulsion_tolerance);
  }
}

TEST_CASE("stationarity: the derivative of Z by a^α is A_α - Q_α, and by a_i gives the reaction", "[gauss]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(9);
    const auto paper = nonholonomic::build_paper_system(c.model);
    const gauss::System& system = paper->system;
    const symbolic::Chart& chart = paper->chart();
    PaperNumbers number(c.model, *paper, c.values);
    INFO(model.name);
    for (const FreeIndex a : chart.free()) {
      const GiNaC::ex gradient = at_motion(system.compulsion.dZ_da_q[a], system.compulsion, system.invariant);
      const GiNaC::ex balance = system.invariant.A[chart.full(a)] - system.Q[chart.full(a)];
      CHECK(deviation(number(gradient), number(balance)) < k_compulsion_tolerance);
    }
    // (1.16): with R_i = a_i - F_i in it, ∂Z/∂a_i vanishes.
    GiNaC::exmap reactions;
    for (const HeldIndex i : chart.held())
      reactions[system.compulsion.R_x[i]] = system.invariant.a_x[i] - system.invariant.F_x[i];
    for (const HeldIndex i : chart.held()) {
      const GiNaC::ex gradient = at_motion(system.compulsion.dZ_da_x[i], system.compulsion, system.invariant);
      CHECK(abs(number(gradient.subs(reactions))) < k_compulsion_tolerance);
    }
  }
}

TEST_CASE("no admissible acceleration has a lower Z than the motion", "[gauss]") {
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(10);
    const auto paper = nonholonomic::build_paper_system(c.model);
    PaperNumbers number(c.model, *paper, c.values);
    const Probe p = probe(c.bare);
    Vec motion;
    for (const FreeIndex a : paper->chart().free()) motion.push_back(number(paper->chart()[a].acceleration));
    motion.insert(motion.end(), c.bare.held_acceleration.begin(), c.bare.held_acceleration.end());
    const Real least = quadratic(p, motion);
    const Mat C = number(paper->elimination.c_dep);
    int lower = 0;
    for (int trial = 0; trial < 1000; ++trial) {
      Vec other = motion;
      for (const auto r : paper->partition.independent.indices()) {
        const Real change = normal(engine);
        other[paper->partition.independent[r].value] += change;
        for (const auto mu : paper->partition.dependent.indices()) {
          other[paper->partition.dependent[mu].value] += C[mu.value][r.value] * change;
        }
      }
      if (quadratic(p, other) <= least) ++lower;
    }
    INFO(model.name);
    CHECK(lower == 0);
  }
}
