// Impulses at contacts with friction, against closed forms and the laws themselves.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "catch_shim.hpp"
#include "gauss/event/impulse.hpp"
#include "gauss/event/least_constraint.hpp"
#include "random_metric.hpp"

using gauss::event::ImpactProblem;
using gauss::event::ImpactSolver;
using gauss::event::Impulses;

namespace {

/// Balls in a row with speeds, of which neighbours touch.
ImpactProblem<double> row_of_balls(const std::vector<double>& masses, const std::vector<double>& speeds, double e) {
  const std::size_t n = masses.size();
  ImpactProblem<double> problem;
  problem.speeds = n;
  problem.metric.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) problem.metric[i * n + i] = masses[i];
  for (std::size_t c = 0; c + 1 < n; ++c) {
    for (std::size_t i = 0; i < n; ++i) problem.rows.push_back(i == c ? -1 : i == c + 1 ? 1 : 0);
    problem.rates.push_back(speeds[c + 1] - speeds[c]);
    problem.restitution.push_back(e);
    problem.takes_part.push_back(1);
  }
  return problem;
}

Impulses<double> solved(const ImpactProblem<double>& problem) { return ImpactSolver<double>(problem).solve(); }

/// A ball of inertia 2/5 m r², m = r = 1, on a floor: speeds (vx, vz, w), slip vx - w, gap vz.
ImpactProblem<double> ball_on_floor(double vx, double vz, double w, double e, double mu) {
  ImpactProblem<double> problem;
  problem.speeds = 3;
  problem.metric = {1, 0, 0, 0, 1, 0, 0, 0, 0.4};
  problem.rows = {0, 1, 0, 1, 0, -1};
  problem.rates = {vz, vx - w};
  problem.restitution = {e};
  problem.takes_part = {1};
  problem.slips = {1};
  problem.limits = {mu};
  return problem;
}

double energy(const ImpactProblem<double>& problem, const std::vector<double>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < problem.speeds; ++i)
    for (std::size_t j = 0; j < problem.speeds; ++j) sum += v[i] * problem.metric[i * problem.speeds + j] * v[j] / 2;
  return sum;
}

}  // namespace

TEST_CASE("two balls exchange what their masses and the restitution say", "[event]") {
  for (const double e : {0.0, 0.3, 1.0}) {
    const auto problem = row_of_balls({2, 6}, {1, 0}, e);
    const auto found = solved(problem);
    REQUIRE(found.is_found);
    CHECK(std::abs(found.impulses[0] - 1.5 * (1 + e)) < 1e-14);
    CHECK(std::abs(found.changes[0] + 0.75 * (1 + e)) < 1e-14);
    CHECK(std::abs(found.changes[1] - 0.25 * (1 + e)) < 1e-14);
  }
}

TEST_CASE("balls that part get nothing", "[event]") {
  const auto found = solved(row_of_balls({2, 6}, {0, 1}, 1));
  REQUIRE(found.is_found);
  CHECK(found.impulses[0] == 0);
  CHECK(found.changes[0] == 0);
}

TEST_CASE("five balls that touch: the first goes back with 3/5 and the others go on with 2/5", "[event]") {
  const auto problem = row_of_balls({1, 1, 1, 1, 1}, {1, 0, 0, 0, 0}, 1);
  const auto found = solved(problem);
  REQUIRE(found.is_found);
  const double expected[] = {-0.6, 0.4, 0.4, 0.4, 0.4}, before[] = {1, 0, 0, 0, 0};
  std::vector<double> after(5);
  for (std::size_t i = 0; i < 5; ++i) {
    after[i] = before[i] + found.changes[i];
    CHECK(std::abs(after[i] - expected[i]) < 1e-14);
  }
  CHECK(std::abs(std::accumulate(after.begin(), after.end(), 0.0) - 1) < 1e-14);
  CHECK(std::abs(energy(problem, after) - 0.5) < 1e-14);
}

TEST_CASE("the order of contacts says nothing", "[event]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> mass(0.2, 3), speed(-1, 1);
  for (int round = 0; round < 50; ++round) {
    std::vector<double> masses(6), speeds(6);
    for (double& one : masses) one = mass(random);
    for (double& one : speeds) one = speed(random);
    const auto problem = row_of_balls(masses, speeds, 0.7);
    const auto found = solved(problem);
    REQUIRE(found.is_found);
    auto turned = problem;
    std::vector<std::size_t> order{4, 1, 3, 0, 2};
    for (std::size_t c = 0; c < 5; ++c) {
      turned.rates[c] = problem.rates[order[c]];
      for (std::size_t i = 0; i < 6; ++i) turned.rows[c * 6 + i] = problem.rows[order[c] * 6 + i];
    }
    const auto other = solved(turned);
    REQUIRE(other.is_found);
    for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(found.changes[i] - other.changes[i]) < 1e-13);
    // The law: rates no less than -e times what they were, impulses no pulls, and one of both is at its bound.
    for (std::size_t c = 0; c < 5; ++c) {
      double rate = problem.rates[c];
      for (std::size_t i = 0; i < 6; ++i) rate += problem.rows[c * 6 + i] * found.changes[i];
      const double above = rate - (problem.rates[c] < 0 ? -0.7 * problem.rates[c] : 0);
      CHECK(above > -1e-12);
      CHECK(found.impulses[c] >= 0);
      CHECK(std::abs(above * found.impulses[c]) < 1e-12);
    }
  }
}

TEST_CASE("what does not take part has no impulse", "[event]") {
  auto problem = row_of_balls({1, 1, 1}, {1, 0, 0}, 1);
  problem.takes_part[1] = 0;
  const auto found = solved(problem);
  REQUIRE(found.is_found);
  CHECK(found.impulses[1] == 0);
  CHECK(std::abs(found.changes[1] - 1) < 1e-15);
  CHECK(found.changes[2] == 0);
}

TEST_CASE("a constraint takes part in an impact: masses are those of what is tied together", "[event]") {
  // Three balls of which the last two are tied: 1 meets 2.
  auto problem = row_of_balls({1, 1, 1}, {1, 0, 0}, 1);
  problem.constraints = 1;
  std::swap_ranges(problem.rows.begin(), problem.rows.begin() + 3, problem.rows.begin() + 3);
  std::swap(problem.rates[0], problem.rates[1]);
  problem.restitution.pop_back();
  problem.takes_part.pop_back();
  const auto found = solved(problem);
  REQUIRE(found.is_found);
  CHECK(std::abs(found.changes[0] + 4.0 / 3) < 1e-14);
  CHECK(std::abs(found.changes[1] - 2.0 / 3) < 1e-14);
  CHECK(std::abs(found.changes[2] - 2.0 / 3) < 1e-14);
}

TEST_CASE("doubled contacts give the same speeds", "[event]") {
  auto problem = row_of_balls({2, 6}, {1, 0}, 0.5);
  problem.rows.insert(problem.rows.end(), {-1, 1});
  problem.rates.push_back(-1);
  problem.restitution.push_back(0.5);
  problem.takes_part.push_back(1);
  const auto found = solved(problem);
  REQUIRE(found.is_found);
  CHECK(std::abs(found.changes[0] + 0.75 * 1.5) < 1e-13);
  CHECK(found.impulses[0] >= 0);
  CHECK(found.impulses[1] >= 0);
}

TEST_CASE("friction of an impact stops slip where it can: 2/7 of the slip, and no more than its limit", "[event]") {
  for (const double mu : {0.0, 0.05, 0.2, 1.0, 50.0}) {
    for (const double slip : {3.0, -3.0}) {
      const auto found = solved(ball_on_floor(slip, -2, 0, 0.5, mu));
      REQUIRE(found.is_found);
      CHECK(std::abs(found.impulses[0] - 3) < 1e-13);
      const double expected = std::min(mu * 3, 2.0 / 7 * 3) * (slip > 0 ? -1 : 1);
      CHECK(std::abs(found.impulses[1] - expected) < 1e-12);
      CHECK(std::abs(found.changes[0] - expected) < 1e-12);
      CHECK(std::abs(found.changes[2] + expected / 0.4) < 1e-12);
    }
  }
}

TEST_CASE("friction in two directions acts against the slip that is left", "[event]") {
  ImpactProblem<double> problem;  // a particle: (vx, vy, vz) = (3, -4, -1)
  problem.speeds = 3;
  problem.metric = {2, 0, 0, 0, 2, 0, 0, 0, 2};
  problem.rows = {0, 0, 1, 1, 0, 0, 0, 1, 0};
  problem.rates = {-1, 3, -4};
  problem.restitution = {0};
  problem.takes_part = {1};
  problem.slips = {2};
  problem.limits = {0.5};
  const auto found = solved(problem);
  REQUIRE(found.is_found);
  CHECK(std::abs(found.impulses[0] - 2) < 1e-13);
  CHECK(std::abs(found.impulses[1] + 0.6) < 1e-12);
  CHECK(std::abs(found.impulses[2] - 0.8) < 1e-12);
  problem.limits = {20};
  const auto stuck = solved(problem);
  REQUIRE(stuck.is_found);
  CHECK(std::abs(stuck.changes[0] + 3) < 1e-13);
  CHECK(std::abs(stuck.changes[1] - 4) < 1e-13);
}

TEST_CASE("friction takes energy, and never gives any", "[event]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> entry(-2, 2), part(0, 1);
  for (int round = 0; round < 300; ++round) {
    const double vx = entry(random), vz = -std::abs(entry(random)), w = entry(random), e = part(random);
    const auto problem = ball_on_floor(vx, vz, w, e, part(random));
    const auto found = solved(problem);
    REQUIRE(found.is_found);
    const std::vector<double> before{vx, vz, w};
    const std::vector<double> after{vx + found.changes[0], vz + found.changes[1], w + found.changes[2]};
    CHECK(energy(problem, after) <= energy(problem, before) * (1 + 1e-12));
    CHECK(std::abs(after[1] + e * vz) < 1e-12);
  }
}

TEST_CASE("impacts of several rough contacts at once have impulses that give no energy, whatever their restitution",
          "[event]") {
  // A body in a plane that touches two faces. Newton's law has no impulses for one in a hundred, and gives energy to another one.
  std::mt19937 engine(17);
  std::uniform_real_distribution<double> any(-1, 1), part(0, 1);
  int closing = 0;
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    ImpactProblem<double> problem;
    problem.speeds = 3;
    problem.metric = {1, 0, 0, 0, 1, 0, 0, 0, 0.1 + part(engine)};
    std::vector<double> before{any(engine), any(engine), any(engine)}, normals, slips;
    for (int c = 0; c < 2; ++c) {
      const double angle = 1.5707963267948966 + (c == 0 ? 1 : -1) * (0.2 + part(engine)), arm = 0.5 + part(engine);
      const double turn = 0.6 * any(engine), nx = std::cos(angle), nz = std::sin(angle);
      const double rx = -arm * std::cos(angle + turn), rz = -arm * std::sin(angle + turn);
      for (const double x : {nx, nz, rx * nz - rz * nx}) normals.push_back(x);
      for (const double x : {nz, -nx, -rx * nx - rz * nz}) slips.push_back(x);
      problem.restitution.push_back(part(engine));
      problem.takes_part.push_back(1);
      problem.slips.push_back(1);
    }
    problem.rows = normals;
    problem.rows.insert(problem.rows.end(), slips.begin(), slips.end());
    for (std::size_t k = 0; k < 4; ++k)
      problem.rates.push_back(problem.rows[3 * k] * before[0] + problem.rows[3 * k + 1] * before[1] +
                              problem.rows[3 * k + 2] * before[2]);
    const double mu = part(engine);
    problem.limits = {mu, 0, 0, mu};
    closing += problem.rates[0] < 0 && problem.rates[1] < 0 ? 1 : 0;
    const auto found = solved(problem);
    REQUIRE(found.is_found);
    std::vector<double> behind = before;
    for (std::size_t i = 0; i < 3; ++i) behind[i] += found.changes[i];
    CHECK(energy(problem, behind) <= energy(problem, before) * (1 + 1e-9));
    for (std::size_t c = 0; c < 2; ++c) {
      double after = problem.rates[c];
      for (std::size_t i = 0; i < 3; ++i) after += problem.rows[3 * c + i] * found.changes[i];
      CHECK(after > -1e-8);
      CHECK(found.impulses[c] > -1e-8);
      CHECK(std::abs(found.impulses[2 + c]) < mu * found.impulses[c] + 1e-8);
    }
  }
  CHECK(closing > 50);
}

TEST_CASE("in float there are impulses to digits of float", "[event]") {
  ImpactProblem<float> problem;
  problem.speeds = 2;
  problem.metric = {2, 0, 0, 6};
  problem.rows = {-1, 1};
  problem.rates = {-1.1F};
  problem.restitution = {0.9F};
  problem.takes_part = {1};
  const Impulses<float> found = ImpactSolver<float>(problem).solve();
  CHECK(found.is_found);
  CHECK(std::abs(found.impulses[0] - 1.5F * 1.9F * 1.1F) < 1e-6F);
}

TEST_CASE("a contact that nothing can move takes no impulse and has no solution if it closes", "[event]") {
  ImpactProblem<double> problem;
  problem.speeds = 1;
  problem.metric = {1};
  problem.rows = {0};
  problem.rates = {-1};
  problem.restitution = {0};
  problem.takes_part = {1};
  CHECK_FALSE(solved(problem).is_found);
}

TEST_CASE("without friction an impact is the convex quadratic programme that it is the solution of", "[event]") {
  // u+ - u- is the least change with gamma+ >= -e gamma- (docs/theory.md, section 11): here by active sets, there by relaxation.
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> any(-1, 1), part(0, 1);
  int compared = 0, parted = 0;
  for (int round = 0; round < 300; ++round) {
    const std::size_t n = 3 + static_cast<std::size_t>(round) % 5, contacts = 1 + static_cast<std::size_t>(round) % 4;
    ImpactProblem<double> impact;
    impact.speeds = n;
    impact.constraints = n > 4 ? 1 : 0;
    std::vector<double> before(n);
    for (double& one : before) one = any(engine);
    impact.metric = random_metric(engine, n);
    gauss::event::ContactProblem<double> programme{n, impact.constraints, impact.metric, {}, {}};
    for (std::size_t k = 0; k < impact.constraints + contacts; ++k) {
      double rate = 0;
      for (std::size_t i = 0; i < n; ++i) {
        impact.rows.push_back(any(engine));
        rate += impact.rows.back() * before[i];
      }
      impact.rates.push_back(rate);
      if (k < impact.constraints) {
        programme.right.push_back(-rate);
        continue;
      }
      const double e = part(engine);
      impact.restitution.push_back(e);
      impact.takes_part.push_back(1);
      programme.right.push_back((rate < 0 ? -e * rate : 0) - rate);
    }
    programme.rows = impact.rows;
    const Impulses<double> found = solved(impact);
    const auto expected = gauss::event::LeastConstraint<double>(programme).solve();
    CAPTURE(round, n, contacts);
    if (!expected.is_found) continue;
    REQUIRE(found.is_found);
    ++compared;
    double size = 1;
    for (const double one : expected.change) size = std::max(size, std::abs(one));
    for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(found.changes[i] - expected.change[i]) < 1e-9 * size);
    for (std::size_t k = impact.constraints; k < impact.count(); ++k) parted += expected.reactions[k] == 0 ? 1 : 0;
  }
  CHECK(compared > 250);
  CHECK(parted > 100);
}

TEST_CASE("what comes to rest with all the friction that a contact has is not pushed on by it", "[event]") {
  // A box with one foot on the floor, and sliding on it, whose other foot hits: the motion of tests/sim/cli/test_regimes_impacts.py. Both slips come to rest, one
  // friction at its limit; the sign of what rounding leaves of a slip is no direction.
  for (const double rounding : {-1e-15, 0.0, 1e-15}) {
    ImpactProblem<double> problem;
    problem.speeds = 3;
    problem.metric = {1, 0, 0, 0, 1, 0, 0, 0, 0.34 / 3};
    problem.rows = {0, 1, 0.5, 0, 1, -0.5, 1, 0, -0.3, 1, 0, -0.3};
    problem.rates = {-1.2459003107558324, rounding, 0.21181098843110366, 0.21181098843110366 + rounding};
    problem.restitution = {0.4, 0.4};
    problem.takes_part = {1, 1};
    problem.slips = {1, 1};
    problem.limits = {0.4, 0, 0, 0.4};
    const Impulses<double> found = solved(problem);
    REQUIRE(found.is_found);
    const auto after = [&](std::size_t k) {
      double sum = problem.rates[k];
      for (std::size_t i = 0; i < 3; ++i) sum += problem.rows[k * 3 + i] * found.changes[i];
      return sum;
    };
    CHECK(std::abs(after(0) - 0.4 * 1.2459003107558324) < 1e-14);
    CHECK(std::abs(after(1)) < 1e-14);
    CHECK(std::abs(after(2)) < 1e-14);
    for (std::size_t f = 0; f < 2; ++f) CHECK(std::abs(found.impulses[2 + f]) <= 0.4 * found.impulses[f] * (1 + 1e-12));
  }
}
