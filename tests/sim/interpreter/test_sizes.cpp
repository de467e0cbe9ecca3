// A system whose sizes are known at run time is solved as one whose sizes compilers know.

#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "sim/interpreter/general_solution.hpp"

namespace {

template <int n, int l>
struct System {
  double g[n][n], f[n], b[l][n], reach[l][n], of_positions[l], off[l], drift[l], drift_error[l];
};

/// Of full rank, and with rows that follow from others, or say nothing.
template <int n, int l>
System<n, l> random_system(std::mt19937& engine, int kind) {
  const auto random = [&] { return std::uniform_real_distribution<double>(-1, 1)(engine); };
  System<n, l> system{};
  for (int i = 0; i < n; ++i) {
    system.f[i] = random();
    for (int j = 0; j <= i; ++j) system.g[i][j] = system.g[j][i] = i == j ? 2 + n + random() : random();
  }
  for (int mu = 0; mu < l; ++mu) {
    const bool follows = kind > 0 && mu > 0 && mu % 2 == 0;
    for (int i = 0; i < n; ++i) {
      system.b[mu][i] = follows ? 0.5 * system.b[mu - 1][i] : kind == 2 && mu == 1 ? 0 : random();
      system.reach[mu][i] = 2;
    }
    system.drift[mu] = follows ? 0.5 * system.drift[mu - 1] : random();
    system.of_positions[mu] = mu % 3 == 0 ? 1 : 0;
  }
  return system;
}

/// As a frame has it, with room for what is solved.
template <int n, int l>
std::vector<double> slots_of(const System<n, l>& system) {
  const auto* const first = reinterpret_cast<const double*>(&system);
  std::vector<double> slots(first, first + sizeof system / sizeof(double));
  slots.resize(slots.size() + n + 2 * l + 4);
  return slots;
}

gausssim::Solve solve_of(int n, int l, gausssim::RankRuleKind rule) {
  gausssim::Solve solve;
  solve.speeds = n;
  solve.rows = l;
  solve.rule = rule;
  solve.usual = n < l ? n : l;
  auto at = [next = 0](int count) mutable { return static_cast<gausssim::Slot>((next += count) - count); };
  solve.g = at(n * n);
  solve.f = at(n);
  solve.b = at(l * n);
  solve.reach = at(l * n);
  solve.of_positions = at(l);
  solve.off = at(l);
  solve.drift = at(l);
  solve.drift_error = at(l);
  solve.solution = at(0);
  return solve;
}

/// Of arrays for `count`, against arrays of n and l.
template <int count, int n, int l>
void compare(std::mt19937& engine, int kind, gausssim::RankRuleKind rule) {
  INFO(n << " speeds, " << l << " constraints, kind " << kind);
  const System<n, l> system = random_system<n, l>(engine, kind);
  std::vector<double> slots = slots_of(system);
  const gausssim::Solve solve = solve_of(n, l, rule);
  gausssim::GeneralSolution<double, count>(solve, slots.data()).solve();

  gauss::LinearSolution<double, n, l> known;
  gauss::solve(system, gausssim::rank_rule<double>(solve, slots.data()), known);
  std::vector<double> expected;
  expected.insert(expected.end(), known.accelerations, known.accelerations + n);
  expected.insert(expected.end(), known.multipliers, known.multipliers + l);
  expected.insert(expected.end(), known.is_shared, known.is_shared + l);
  expected.push_back(known.rank);
  for (const gauss::Status status : {known.motion, known.step, known.reactions})
    expected.push_back(static_cast<int>(status));
  const std::vector<double> found(slots.begin() + solve.solution, slots.end());
  CHECK(found == expected);
}

template <int n, int l>
void compare_all(std::mt19937& engine) {
  for (int kind = 0; kind < 3; ++kind) {
    for (const auto rule :
         {gausssim::RankRuleKind::positions, gausssim::RankRuleKind::velocities, gausssim::RankRuleKind::steps}) {
      compare<8, n, l>(engine, kind, rule);
      compare<gausssim::k_most_of_system, n, l>(engine, kind, rule);
    }
  }
}

}  // namespace

TEST_CASE("sizes that are known at run time give the bits of those that compilers know") {
  std::mt19937 engine(3);
  for (int round = 0; round < 5; ++round) {
    compare_all<1, 1>(engine);
    compare_all<3, 2>(engine);
    compare_all<2, 5>(engine);
    compare_all<6, 4>(engine);
    compare_all<5, 8>(engine);
    compare_all<8, 8>(engine);
  }
}
