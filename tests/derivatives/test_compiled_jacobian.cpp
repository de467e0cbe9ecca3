// The emitted Jacobian beside the emitted right-hand side run with dual numbers, for every model, compiled.

#include "jacobian_headers.inc"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "dual.hpp"

namespace {

using derivatives::Dual;
using Matrix = std::vector<double>;  ///< one row after the other

constexpr int k_states = 20;
/// Of the largest entry: both solve the same linear systems, with conditions up to some 1e3 at these states.
constexpr double k_tolerance = 1e-12;
constexpr double k_time = 0.3;

struct Seen {
  int states = 0;
  double worst = 0;
};

void compare(const Matrix& found, const Matrix& expected, Seen& seen) {
  double size = 1, worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    size = std::max(size, std::fabs(expected[i]));
    const double off = std::fabs(found[i] - expected[i]);
    worst = off <= worst ? worst : off;
  }
  seen.worst = std::max(seen.worst, worst / size);
}

/// A model at one state, its right-hand side in dual numbers.
template <class M>
class Rates {
 public:
  static constexpr int n = M::n_q + M::n_v;

  Rates(typename M::template State<double> state, typename M::template Inputs<double> inputs)
      : state_(state), inputs_(inputs) {}

  /// The rates of the rates, with the rate 1 in one variable of the state, in one input, or in time.
  Matrix column(int of_state, int of_input, double of_time) const {
    typename M::template State<Dual> state;
    for (int i = 0; i < n; ++i) state.values[i] = Dual(state_.values[i], i == of_state ? 1 : 0);
    typename M::template Inputs<Dual> inputs{};
    for (int i = 0; i < M::inputs_count(); ++i)
      inputs.*M::template inputs_of<Dual>()[i] =
          Dual(inputs_.*M::template inputs_of<double>()[i], i == of_input ? 1 : 0);
    typename M::template Derivative<Dual> derivative;
    (void)rhs(Dual(k_time, of_time), state, inputs, prepared_, derivative);
    Matrix result;
    for (const Dual& value : derivative.values) result.push_back(value.rate);
    return result;
  }

 private:
  typename M::template State<double> state_;
  typename M::template Inputs<double> inputs_;
  typename M::template Prepared<Dual> prepared_ = prepare(typename M::template Parameters<Dual>{});
};

template <class Pattern, class Jacobian, class Column>
void compare_matrix(const Jacobian& jacobian, Column&& column, Seen& seen) {
  Matrix found(static_cast<std::size_t>(Pattern::rows * Pattern::columns));
  Matrix expected(found.size());
  dense(jacobian, Pattern{}, found.data());
  for (int k = 0; k < Pattern::columns; ++k) {
    const Matrix entries = column(k);
    for (int i = 0; i < Pattern::rows; ++i)
      expected[static_cast<std::size_t>(i * Pattern::columns + k)] = entries[static_cast<std::size_t>(i)];
  }
  compare(found, expected, seen);
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
    for (int i = 0; i < M::inputs_count(); ++i) inputs.*M::template inputs_of<double>()[i] += any(random);
    typename M::template JacobianOf<double> jacobian{};
    if (M::jacobian_at(k_time, state, inputs, prepared, jacobian) != gauss::Status::ok) continue;
    ++seen.states;
    const Rates<M> rates(state, inputs);
    compare_matrix<typename M::ByState>(
        jacobian, [&](int k) { return rates.column(k, -1, 0); }, seen);
    compare_matrix<typename M::ByInputs>(
        jacobian, [&](int k) { return rates.column(-1, k, 0); }, seen);
    compare_matrix<typename M::ByTime>(
        jacobian, [&](int) { return rates.column(-1, -1, 1); }, seen);
  }
  return seen;
}

}  // namespace

TEST_CASE(
    "the emitted Jacobian is what dual numbers make of the emitted right-hand side, and zero outside of its pattern") {
  const auto check = [](const char* name, const Seen& seen) {
    std::printf("%-32s %3d states %10.2g\n", name, seen.states, seen.worst);
    INFO(name);
    CHECK(seen.states == k_states);
    CHECK(seen.worst < k_tolerance);
  };
#define GAUSS_TESTED_MODEL(name_space) check(#name_space, seen_of<name_space::Tested>());
#include "jacobian_models.inc"
#undef GAUSS_TESTED_MODEL
}
