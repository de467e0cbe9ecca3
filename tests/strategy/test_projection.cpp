// project: unit quaternions, then the smallest change of the speeds in the mass metric (theory, section 3).

#include <algorithm>

#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "strategy/emitted_numbers.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_tolerance = 1e-14;

/// The part of a free covector that no combination of the rows of β over the free coordinates gives, by least squares.
Vec beyond_rows(const Probe& p, const Vec& covector) {
  const std::size_t n = covector.size();
  const std::size_t l = p.beta.size();
  Mat normal(l, Vec(l, 0));
  Vec right(l, 0);
  for (std::size_t i = 0; i < l; ++i) {
    for (std::size_t a = 0; a < n; ++a) right[i] += p.beta[i][a] * covector[a];
    for (std::size_t j = 0; j < l; ++j) {
      for (std::size_t a = 0; a < n; ++a) normal[i][j] += p.beta[i][a] * p.beta[j][a];
    }
  }
  const Vec size = solve(normal, right);
  Vec rest = covector;
  for (std::size_t i = 0; i < l; ++i) {
    for (std::size_t a = 0; a < n; ++a) rest[a] -= size[i] * p.beta[i][a];
  }
  return rest;
}

/// Speeds after `project` at the state of `c`, whose quaternions are made too long first.
struct Projected {
  Vec configuration;
  Vec speeds;
};

Projected projected(const Case& c) {
  Case lengthened = c;
  for (const auto& orientation : c.model.orientations) {
    for (const auto& component : orientation.quaternion) lengthened.values.at(component.text) *= Real("1.5");
  }
  EmittedNumbers emitted(lengthened);
  const Vec state = emitted.state("project");
  // One step does not reach a constraint nonlinear in the velocities, and says so.
  const auto& rows = emitted.mechanics().kinematics.constraints;
  const bool is_linear = std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.is_linear; });
  const std::vector<std::string> expected(is_linear ? 0 : 1, "violated constraints");
  CHECK(emitted.troubles("project") == expected);
  const auto middle = state.begin() + static_cast<long>(emitted.mechanics().symbols.configuration.size());
  return {{state.begin(), middle}, {middle, state.end()}};
}

}  // namespace

TEST_CASE("project gives quaternions unit length and leaves coordinates alone") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(1);
    Vec expected;
    for (const auto& coordinate : c.model.coordinates) {
      if (!coordinate.held_at) expected.push_back(c.values.at(coordinate.name.text));
    }
    for (const auto& orientation : c.model.orientations) {
      for (const auto& component : orientation.quaternion) expected.push_back(c.values.at(component.text));
    }
    INFO(model.name);
    CHECK(deviation(projected(c).configuration, expected) < k_tolerance);
  }
}

TEST_CASE("project satisfies phi to first order: exactly where phi is linear in the velocities") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(2);
    if (!c.bare.constraints) continue;
    const Vec speeds = projected(c).speeds;
    const Probe p = probe(c.bare);
    Vec linearised = c.bare.constraints(c.bare.y, c.bare.rate, c.bare.t);
    for (std::size_t mu = 0; mu < linearised.size(); ++mu) {
      for (std::size_t a = 0; a < speeds.size(); ++a) linearised[mu] += p.beta[mu][a] * (speeds[a] - c.bare.rate[a]);
    }
    INFO(model.name);
    CHECK(deviation(linearised, Vec(linearised.size(), 0)) < k_tolerance);
  }
}

TEST_CASE("project changes the speeds least in the mass metric: g du is a combination of constraint rows") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(3);
    if (!c.bare.constraints) continue;
    const Vec speeds = projected(c).speeds;
    const Probe p = probe(c.bare);
    Vec momentum(speeds.size(), 0);
    Vec change(speeds.size(), 0);
    for (std::size_t a = 0; a < speeds.size(); ++a) {
      change[a] = speeds[a] - c.bare.rate[a];
      for (std::size_t b = 0; b < speeds.size(); ++b) momentum[a] += p.G[a][b] * (speeds[b] - c.bare.rate[b]);
    }
    INFO(model.name);
    CHECK(deviation(beyond_rows(p, momentum), Vec(speeds.size(), 0)) < k_tolerance);
    // Not so in another metric: with unit masses the test would see the difference.
    CHECK(deviation(beyond_rows(p, change), Vec(speeds.size(), 0)) > 1e-3);
  }
}

TEST_CASE("a model without constraints keeps its speeds") {
  const Case c = case_of("skew_chart", 4);
  CHECK(projected(c).speeds == Vec(c.bare.rate.begin(), c.bare.rate.begin() + static_cast<long>(c.bare.free_count)));
}
