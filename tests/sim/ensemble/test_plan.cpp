// Values of trajectories: by seed, number and name alone, and distributed as asked for.
#include <algorithm>
#include <cmath>

#include "catch_shim.hpp"
#include "sim/ensemble/plan.hpp"

namespace {

using gausssim::Distribution;
using gausssim::Ensemble;
using gausssim::Plan;
using gausssim::Section;
using gausssim::Varied;
using Kind = Distribution::Kind;

Varied draw(const char* name, Kind kind, double a, double b) {
  return {Section::parameters, name, {kind, a, b, {}}, {}};
}

Varied sweep(const char* name, std::vector<double> points) {
  return {Section::parameters, name, {Kind::points, 0, 0, std::move(points)}, {}};
}

Ensemble of(std::vector<Varied> varied, long trajectories, std::uint64_t seed = 1) {
  Ensemble ensemble;
  ensemble.varied = std::move(varied);
  ensemble.trajectories = trajectories;
  ensemble.seed = seed;
  return ensemble;
}

std::vector<double> sorted_draws(Kind kind, double a, double b, long count) {
  const Plan plan(of({draw("x", kind, a, b)}, count));
  std::vector<double> all;
  for (long i = 0; i < count; ++i) all.push_back(plan.values(i)[0]);
  std::sort(all.begin(), all.end());
  return all;
}

/// The largest distance between the share of values below one and what it should be (Kolmogorov and Smirnov), times the root of the count:
/// above 1.95 once in a thousand sets.
template <class Share>
double distance(const std::vector<double>& sorted, const Share& share_below) {
  const auto count = static_cast<double>(sorted.size());
  double most = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double share = share_below(sorted[i]);
    most = std::max(
        {most, std::abs(share - static_cast<double>(i) / count), std::abs(share - static_cast<double>(i + 1) / count)});
  }
  return most * std::sqrt(count);
}

constexpr long k_count = 20'000;

}  // namespace

TEST_CASE("draws are distributed as they are called") {
  const auto uniform = sorted_draws(Kind::uniform, -1, 3, k_count);
  CHECK(uniform.front() >= -1);
  CHECK(uniform.back() <= 3);
  CHECK(distance(uniform, [](double x) { return (x + 1) / 4; }) < 1.95);
  const auto normal = sorted_draws(Kind::normal, 2, 0.5, k_count);
  CHECK(distance(normal, [](double x) { return std::erfc(-(x - 2) / 0.5 / std::sqrt(2.0)) / 2; }) < 1.95);
  const auto logarithmic = sorted_draws(Kind::log_uniform, 0.01, 100, k_count);
  CHECK(logarithmic.front() >= 0.01);
  CHECK(distance(logarithmic, [](double x) { return std::log(x / 0.01) / std::log(1e4); }) < 1.95);
}

TEST_CASE("a value knows seed, number and name, and nothing else") {
  const Varied x = draw("x", Kind::uniform, 0, 1), y = draw("y", Kind::uniform, 0, 1);
  const Plan alone(of({x}, 10)), longer(of({x}, 1000)), beside(of({y, x}, 10)), other(of({x}, 10, 2));
  Varied initial = x;
  initial.section = Section::initial;
  const Plan elsewhere(of({initial}, 10));
  for (long i = 0; i < 10; ++i) {
    CHECK(alone.values(i)[0] == longer.values(i)[0]);
    CHECK(alone.values(i)[0] == beside.values(i)[1]);
    CHECK(alone.values(i)[0] != beside.values(i)[0]);
    CHECK(alone.values(i)[0] != other.values(i)[0]);
    CHECK(alone.values(i)[0] != elsewhere.values(i)[0]);
  }
}

TEST_CASE("draws of two names do not follow each other") {
  const Plan plan(of({draw("x", Kind::normal, 0, 1), draw("y", Kind::normal, 0, 1)}, k_count));
  double sum = 0, next = 0;
  for (long i = 0; i < k_count; ++i) {
    sum += plan.values(i)[0] * plan.values(i)[1];
    next += plan.values(i)[0] * plan.values(i + 1)[0];
  }
  CHECK(std::abs(sum) < 3.5 * std::sqrt(double(k_count)));
  CHECK(std::abs(next) < 3.5 * std::sqrt(double(k_count)));
}

TEST_CASE("sweeps make all pairs, the last one fastest, and draws repeat behind them") {
  const Plan plan(of({sweep("a", {1, 2}), draw("x", Kind::uniform, 0, 1), sweep("b", {10, 20, 30})}, 2));
  REQUIRE(plan.count() == 12);
  const double a[] = {1, 1, 1, 2, 2, 2}, b[] = {10, 20, 30, 10, 20, 30};
  for (long i = 0; i < 12; ++i) {
    CHECK(plan.values(i)[0] == a[i % 6]);
    CHECK(plan.values(i)[2] == b[i % 6]);
  }
  CHECK(plan.values(0)[1] != plan.values(6)[1]);
}

TEST_CASE("large numbers of trajectories have draws of their own") {
  const Plan plan(of({draw("x", Kind::uniform, 0, 1)}, gausssim::k_most_trajectories));
  CHECK(plan.values(5)[0] != plan.values(5 + (1L << 32))[0]);
}
