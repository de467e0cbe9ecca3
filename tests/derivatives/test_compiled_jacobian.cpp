// The emitted Jacobian beside the emitted right-hand side run with dual numbers, and both beside its differences in long double,
// for every model, compiled.

#include "jacobian_headers.inc"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "rates.hpp"

namespace {

using derivatives::Matrix;
using derivatives::Rates;

constexpr int k_states = 20;
/// Of the largest entry: both solve the same linear systems, with conditions up to some 1e3 at these states.
constexpr double k_tolerance = 1e-12;
/// The fourth power of a step of 1e-4 times the fifth derivative: that of a pivot which shakes at 2000 rad/s takes most of it.
constexpr double k_tolerance_of_differences = 1e-7;
constexpr double k_time = 0.3;

struct Seen {
  int states = 0;
  double worst = 0, worst_difference = 0;
};

double deviation(const Matrix& found, const Matrix& expected) {
  double size = 1, worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    size = std::max(size, std::fabs(expected[i]));
    const double off = std::fabs(found[i] - expected[i]);
    worst = off <= worst ? worst : off;
  }
  return worst / size;
}

/// Some columns of a matrix.
Matrix part(const Matrix& whole, int columns, int first, int count) {
  Matrix result;
  for (auto row = whole.begin(); row != whole.end(); row += columns)
    result.insert(result.end(), row + first, row + first + count);
  return result;
}

template <class Pattern, class Jacobian>
Matrix entries(const Jacobian& jacobian) {
  Matrix found(static_cast<std::size_t>(Pattern::rows * Pattern::columns));
  dense(jacobian, Pattern{}, found.data());
  return found;
}

template <class M>
void compare(const typename M::template JacobianOf<double>& jacobian, const Rates<M>& rates, Seen& seen) {
  constexpr int n = Rates<M>::n, inputs = Rates<M>::n_inputs, columns = Rates<M>::columns;
  const Matrix whole = rates.by_dual_numbers();
  for (const double worst : {deviation(entries<typename M::ByState>(jacobian), part(whole, columns, 0, n)),
                             deviation(entries<typename M::ByInputs>(jacobian), part(whole, columns, n, inputs)),
                             deviation(entries<typename M::ByTime>(jacobian), part(whole, columns, n + inputs, 1))}) {
    seen.worst = worst <= seen.worst ? seen.worst : worst;
  }
  const double difference = deviation(whole, rates.by_differences());
  seen.worst_difference = difference <= seen.worst_difference ? seen.worst_difference : difference;
}

template <class M>
Seen seen_of() {
  const auto prepared = prepare(typename M::template Parameters<double>{});
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  Seen seen;
  for (int tries = 0; tries < 10 * k_states && seen.states < k_states; ++tries) {
    // Linkages do not come back from far away.
    const double distance = std::ldexp(0.2, -tries / k_states);
    typename M::template State<double> start{}, state{};
    if (initial_state(prepared, start) != gauss::Status::ok) break;
    for (double& value : start.values) value += distance * any(random);
    if (project(k_time, start, prepared, state) != gauss::Status::ok) continue;
    typename M::template Inputs<double> inputs{};
    for (int i = 0; i < M::n_inputs; ++i) inputs.*M::template inputs_of<double>()[i] += any(random);
    typename M::template JacobianOf<double> jacobian{};
    if (M::jacobian_at(k_time, state, inputs, prepared, jacobian) != gauss::Status::ok) continue;
    ++seen.states;
    compare<M>(jacobian, Rates<M>(k_time, state, inputs), seen);
  }
  return seen;
}

}  // namespace

TEST_CASE(
    "the emitted Jacobian is what dual numbers make of the emitted right-hand side, zero outside of its pattern, and "
    "the "
    "limit of its differences") {
  const auto check = [](const char* name, const Seen& seen) {
    std::printf("%-32s %3d states %10.2g %10.2g\n", name, seen.states, seen.worst, seen.worst_difference);
    INFO(name);
    CHECK(seen.states == k_states);
    CHECK(seen.worst < k_tolerance);
    CHECK(seen.worst_difference < k_tolerance_of_differences);
  };
#define GAUSS_TESTED_MODEL(name_space) check(#name_space, seen_of<name_space::Tested>());
#include "jacobian_models.inc"
#undef GAUSS_TESTED_MODEL
}
