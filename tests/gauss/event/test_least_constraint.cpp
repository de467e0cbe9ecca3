// Gauss's principle with inequalities: against all sets of contacts that may be closed, tried one by one, and closed forms.

#include <algorithm>
#include <cmath>
#include <random>

#include "catch_shim.hpp"
#include "gauss/event/least_constraint.hpp"
#include "random_metric.hpp"

using gauss::event::ContactAccelerations;
using gauss::event::ContactProblem;
using gauss::event::DenseMatrix;
using gauss::event::LeastConstraint;
using gauss::event::solve_dense;

namespace {

double row_times(const ContactProblem<double>& problem, std::size_t row, const std::vector<double>& d) {
  double sum = 0;
  for (std::size_t i = 0; i < problem.speeds; ++i) sum += problem.rows[row * problem.speeds + i] * d[i];
  return sum;
}

/// Stationary with the chosen rows as equations: the multipliers stand behind the accelerations.
std::vector<double> with_equations(const ContactProblem<double>& problem, const std::vector<std::size_t>& chosen) {
  const std::size_t n = problem.speeds, size = n + chosen.size();
  DenseMatrix<double> system(size, size);
  std::vector<double> right(size, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) system(i, j) = problem.metric[i * n + j];
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    right[n + k] = problem.right[chosen[k]];
    for (std::size_t i = 0; i < n; ++i) {
      system(n + k, i) = problem.rows[chosen[k] * n + i];
      system(i, n + k) = -problem.rows[chosen[k] * n + i];
    }
  }
  return solve_dense(std::move(system), std::move(right));
}

/// The set of contacts, of all, in which none pulls and none overlaps. Empty: there is none.
std::vector<double> by_all_sets(const ContactProblem<double>& problem) {
  const std::size_t contacts = problem.count() - problem.equations;
  for (std::size_t set = 0; set < std::size_t(1) << contacts; ++set) {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < problem.equations; ++k) chosen.push_back(k);
    for (std::size_t c = 0; c < contacts; ++c)
      if ((set >> c & 1U) != 0) chosen.push_back(problem.equations + c);
    const std::vector<double> found = with_equations(problem, chosen);
    bool holds = true;
    double size = 1;
    for (const double one : found) size = std::max(size, std::abs(one));
    const double rounding = 1e-9 * size;
    for (std::size_t k = 0; k < problem.count(); ++k) {
      const double above = row_times(problem, k, found) - problem.right[k];
      holds = holds && (k < problem.equations ? std::abs(above) < rounding : above > -rounding);
    }
    for (std::size_t k = problem.equations; k < chosen.size(); ++k)
      holds = holds && found[problem.speeds + k] > -rounding;
    if (holds) return {found.begin(), found.begin() + static_cast<std::ptrdiff_t>(problem.speeds)};
  }
  return {};
}

ContactProblem<double> random_problem(std::mt19937& engine, std::size_t n, std::size_t equations,
                                      std::size_t contacts) {
  std::uniform_real_distribution<double> any(-1, 1);
  ContactProblem<double> problem;
  problem.speeds = n;
  problem.equations = equations;
  problem.metric = random_metric(engine, n);
  for (std::size_t k = 0; k < (equations + contacts) * n; ++k) problem.rows.push_back(any(engine));
  for (std::size_t k = 0; k < equations + contacts; ++k) problem.right.push_back(any(engine));
  return problem;
}

}  // namespace

TEST_CASE("of all sets of closed contacts it finds the one in which none pulls and none overlaps", "[event]") {
  std::mt19937 engine(7);
  int parted = 0, none = 0;
  for (int round = 0; round < 400; ++round) {
    const std::size_t n = 2 + static_cast<std::size_t>(round) % 6, equations = n > 3 ? n % 3 : 0;
    const auto problem = random_problem(engine, n, equations, 1 + static_cast<std::size_t>(round) % 8);
    const ContactAccelerations<double> found = LeastConstraint<double>(problem).solve();
    const std::vector<double> expected = by_all_sets(problem);
    CAPTURE(round, n, equations, problem.count());
    REQUIRE(found.is_found == !expected.empty());
    if (!found.is_found) {
      ++none;
      continue;
    }
    double size = 1;
    for (const double one : expected) size = std::max(size, std::abs(one));
    for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(found.change[i] - expected[i]) < 1e-9 * size);
    for (std::size_t k = equations; k < problem.count(); ++k) {
      CHECK(found.reactions[k] >= -1e-12);
      CHECK(found.rates[k] >= -1e-12 * size);
      CHECK((found.reactions[k] == 0 || found.rates[k] == 0));
      parted += found.reactions[k] == 0 ? 1 : 0;
    }
  }
  CHECK(parted > 200);
  CHECK(none > 5);
}

TEST_CASE("reactions are those of the metric: g d is what the rows make", "[event]") {
  std::mt19937 engine(11);
  for (int round = 0; round < 100; ++round) {
    const auto problem = random_problem(engine, 6, 1, 4);
    const ContactAccelerations<double> found = LeastConstraint<double>(problem).solve();
    if (!found.is_found) continue;
    for (std::size_t i = 0; i < problem.speeds; ++i) {
      double force = 0, made = 0;
      for (std::size_t j = 0; j < problem.speeds; ++j)
        force += problem.metric[i * problem.speeds + j] * found.change[j];
      for (std::size_t k = 0; k < problem.count(); ++k)
        made += problem.rows[k * problem.speeds + i] * found.reactions[k];
      CHECK(std::abs(force - made) < 1e-10 * (1 + std::abs(force)));
    }
  }
}

TEST_CASE("a table on four legs stands on them, though three would do", "[event]") {
  // Height and two angles; legs at (±1, ±1). Gravity pulls with 1, off the middle towards one leg.
  ContactProblem<double> problem;
  problem.speeds = 3;
  problem.metric = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  problem.rows = {1, 1, 1, 1, 1, -1, 1, -1, 1, 1, -1, -1};
  const double free[3] = {-1, -0.3, -0.2};
  for (std::size_t k = 0; k < 4; ++k) problem.right.push_back(-row_times(problem, k, {free[0], free[1], free[2]}));
  const ContactAccelerations<double> found = LeastConstraint<double>(problem).solve();
  REQUIRE(found.is_found);
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(found.change[i] + free[i]) < 1e-14);
  double sum = 0;
  for (const double one : found.reactions) {
    CHECK(one >= 0);
    sum += one;
  }
  CHECK(std::abs(sum - 1) < 1e-14);
}

// As planes are that touch a cone beside each other. One more direction satisfies all: so there is an answer.
TEST_CASE("rows that are nearly parallel are no trouble", "[event]") {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    const std::size_t n = 2 + static_cast<std::size_t>(trial % 7), faces = 3 + static_cast<std::size_t>(trial % 5);
    const double tilt = std::pow(10.0, -2 - trial % 8);
    ContactProblem<double> problem;
    problem.speeds = n + 1;
    problem.metric.assign((n + 1) * (n + 1), 0);
    for (std::size_t i = 0; i <= n; ++i) problem.metric[i * (n + 1) + i] = i < n ? 0.01 : 1;
    for (std::size_t f = 0; f < faces; ++f) {
      std::vector<double> face(n);
      for (double& one : face) one = any(engine);
      const double right = 10 * any(engine);
      for (int copy = 0; copy < 3; ++copy) {
        for (const double one : face) problem.rows.push_back(one + tilt * any(engine));
        problem.rows.push_back(1);
        problem.right.push_back(right + tilt * any(engine));
      }
    }
    const ContactAccelerations<double> found = LeastConstraint<double>(problem).solve();
    CAPTURE(trial, tilt);
    REQUIRE(found.is_found);
    double size = 1;
    for (const double one : found.change) size = std::max(size, std::abs(one));
    std::vector<double> left(n + 1);
    for (std::size_t i = 0; i <= n; ++i) left[i] = problem.metric[i * (n + 1) + i] * found.change[i];
    for (std::size_t k = 0; k < problem.count(); ++k) {
      const double above = row_times(problem, k, found.change) - problem.right[k];
      CHECK(above > -1e-9 * size);
      CHECK(found.reactions[k] >= 0);
      CHECK(std::abs(found.reactions[k] * above) < 1e-8 * size * size);
      for (std::size_t i = 0; i <= n; ++i) left[i] -= problem.rows[k * (n + 1) + i] * found.reactions[k];
    }
    for (const double one : left) CHECK(std::abs(one) < 1e-9 * size);
  }
}

TEST_CASE("two contacts that squeeze have no accelerations, and it says so", "[event]") {
  ContactProblem<double> problem;
  problem.speeds = 1;
  problem.metric = {1};
  problem.rows = {1, -1};
  problem.right = {0.5, 0.5};
  CHECK_FALSE(LeastConstraint<double>(problem).solve().is_found);
}

TEST_CASE("a hundred contacts of a chain are found in any order", "[event]") {
  // Particles on a line, each with a floor; every third one is pulled up.
  constexpr std::size_t k_count = 100;
  ContactProblem<double> problem;
  problem.speeds = k_count;
  problem.metric.assign(k_count * k_count, 0);
  problem.rows.assign(k_count * k_count, 0);
  for (std::size_t i = 0; i < k_count; ++i) {
    problem.metric[i * k_count + i] = 2;
    if (i > 0) problem.metric[i * k_count + i - 1] = problem.metric[(i - 1) * k_count + i] = 0.5;
    problem.rows[i * k_count + (i * 37) % k_count] = 1;
    problem.right.push_back((i * 37) % k_count % 3 == 0 ? -1.0 : 1.0);
  }
  const ContactAccelerations<double> found = LeastConstraint<double>(problem).solve();
  REQUIRE(found.is_found);
  for (std::size_t k = 0; k < k_count; ++k) {
    CHECK(found.reactions[k] >= 0);
    CHECK(found.rates[k] >= -1e-12);
    CHECK(found.reactions[k] * found.rates[k] == 0);
  }
}
