// Parameters may be anything at run time. Where a choice that was made for those of the file leaves no digits, the status says so, and
// where it leaves them, it does not.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "catch_shim.hpp"
#include "heavy_hook.hpp"
#include "other_strategies/heavy_hook.hpp"
#include "other_strategies/trailer_0.hpp"
#include "other_strategies/two_bobs.hpp"
#include "planar_chain_relative_100.hpp"
#include "rest_inertia.hpp"
#include "spatial_chain_24.hpp"
#include "tested_model.hpp"
#include "trailer_0.hpp"
#include "trailer_4.hpp"
#include "two_bobs.hpp"

GAUSS_MAKE_TESTED(by_multipliers)
GAUSS_MAKE_TESTED(gauss::trailer_0)
GAUSS_MAKE_TESTED(gauss::trailer_4)
namespace rest_inertia = gauss::rest_inertia;

// The chains have their right-hand side alone.
GAUSS_MODEL(PlanarChain, gauss::planar_chain_relative_100);
GAUSS_MODEL(SpatialChain, gauss::spatial_chain_24);
GAUSS_MODEL(TwoBobs, gauss::two_bobs);
GAUSS_MODEL(TwoBobsByMetric, bobs_by_metric);
GAUSS_MODEL(HeavyHook, gauss::heavy_hook);
GAUSS_MODEL(HeavyHookOnTree, hook_on_tree);

namespace {

using gauss::Status;
using Truth = by_multipliers::Tested;  // whose multiplier is found from the response along the constraint

template <class S>
struct Found {
  std::vector<S> values;
  Status status;
};

template <class M, class S>
Found<S> trailer(S length) {
  typename M::template Parameters<S> parameters;
  parameters.l = length;
  const auto prepared = prepare(parameters);
  typename M::template State<S> state;
  typename M::template Derivative<S> derivative;
  typename M::template ReactionsOrNone<S> reactions;
  (void)initial_state(prepared, state);
  const Status status = rhs_and_reactions(S(0), state, {}, prepared, derivative, reactions);
  std::vector<S> values(derivative.values + M::n_q, derivative.values + M::n_q + M::n_v);
  values.push_back(reactions.across.multiplier);
  return {values, status};
}

/// Relative to the largest.
template <class S>
double difference(const std::vector<S>& found, const std::vector<long double>& expected) {
  long double largest = 0, worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    largest = std::max(largest, std::abs(expected[i]));
    worst = std::max(worst, std::abs(static_cast<long double>(found[i]) - expected[i]));
  }
  return static_cast<double>(worst / largest);
}

/// Of the lengths 10^-k those that are trusted; half of the digits have to be right then.
template <class S>
int trusted_lengths() {
  int trusted = 0;
  for (int k = 0; k <= 12; ++k) {
    const S length = static_cast<S>(std::pow(10.0L, -k));
    const auto expected = trailer<Truth>(static_cast<long double>(length));
    REQUIRE(expected.status == Status::ok);
    const auto found = trailer<gauss::trailer_0::Tested>(length);
    INFO("l = 10^-" << k << ": " << gauss::name(found.status));
    if (found.status != Status::ok) continue;
    ++trusted;
    CHECK(difference(found.values, expected.values) < std::sqrt(static_cast<double>(gauss::Math<S>::epsilon())));
  }
  return trusted;
}

struct Comparison {
  int trusted = 0;
  double worst = 0;
};

/// In float and in long double, at 50 random states.
template <class M>
Comparison in_float() {
  Comparison result;
  std::uint64_t seed = 1986;
  const auto next = [&seed] {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    return static_cast<float>(seed >> 40U) / 8388608.0F - 1.0F;
  };
  const auto coarse = M::prepare(typename M::template Parameters<float>{});
  const auto fine = M::prepare(typename M::template Parameters<long double>{});
  for (int k = 0; k < 50; ++k) {
    typename M::template State<float> state;
    typename M::template State<long double> same;
    for (int i = 0; i < M::n_q + M::n_v; ++i) same.values[i] = static_cast<long double>(state.values[i] = next());
    typename M::template Derivative<float> found;
    typename M::template Derivative<long double> expected;
    REQUIRE(M::rhs(0.0L, same, {}, fine, expected) == Status::ok);
    if (M::rhs(0.0F, state, {}, coarse, found) != Status::ok) continue;
    ++result.trusted;
    const std::vector<float> ours(found.values + M::n_q, found.values + M::n_q + M::n_v);
    const std::vector<long double> right(expected.values + M::n_q, expected.values + M::n_q + M::n_v);
    result.worst = std::max(result.worst, difference(ours, right));
  }
  return result;
}

template <class M, class S>
Status of_two_bobs(S mass_1, S length_1, S mass_2, S length_2) {
  typename M::template Parameters<S> parameters;
  parameters.m1 = mass_1;
  parameters.L1 = length_1;
  parameters.m2 = mass_2;
  parameters.L2 = length_2;
  typename M::template State<S> state{{S(0.4), S(0.3), S(0), S(0)}};
  typename M::template Derivative<S> derivative;
  return M::rhs(S(0), state, {}, M::prepare(parameters), derivative);
}

/// The worst of 200 states in which each angle is within 0.003 of a multiple of a right angle, in double against long double.
template <class M>
double worst_when_aligned() {
  std::uint64_t seed = 11;
  const auto next = [&seed] {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(seed >> 33U) / 1073741824.0 - 1;
  };
  double worst = 0;
  for (int k = 0; k < 200; ++k) {
    typename M::template State<double> state;
    typename M::template State<long double> same;
    for (int i = 0; i < M::n_q + M::n_v; ++i) {
      const double aligned = i < M::n_q ? std::round(2 * next()) * std::acos(0.0) : 0;
      same.values[i] = state.values[i] = aligned + (i < M::n_q ? 0.003 : 1) * next();
    }
    typename M::template Derivative<double> found;
    typename M::template Derivative<long double> expected;
    REQUIRE(M::rhs(0.0L, same, {}, M::prepare(typename M::template Parameters<long double>{}), expected) == Status::ok);
    if (M::rhs(0.0, state, {}, M::prepare(typename M::template Parameters<double>{}), found) != Status::ok) continue;
    const std::vector<double> ours(found.values + M::n_q, found.values + M::n_q + M::n_v);
    const std::vector<long double> right(expected.values + M::n_q, expected.values + M::n_q + M::n_v);
    worst = std::max(worst, difference(ours, right));
  }
  return worst;
}

Status of_rotor(double mass, double rest) {
  rest_inertia::Parameters<double> parameters;
  parameters.m = mass;
  volatile double moment = mass * (parameters.c * parameters.c);  // as somebody else would compute it
  parameters.Jo = moment + rest;
  const rest_inertia::State<double> state{{0.1, 0.2, 0, 0}};
  rest_inertia::Inputs<double> inputs{};
  inputs.T = 1;
  rest_inertia::Derivative<double> derivative;
  return rhs(0.0, state, inputs, prepare(parameters), derivative);
}

}  // namespace

TEST_CASE("a rate that follows from a constraint by a lever that is too short is found by the general solution") {
  CHECK(trusted_lengths<double>() >= 4);
  CHECK(trusted_lengths<float>() >= 2);
  CHECK(trusted_lengths<long double>() >= 4);
  CHECK(trailer<gauss::trailer_0::Tested>(1e-12).status == Status::ok);
  CHECK(trailer<gauss::trailer_0::Tested>(1e-5F).status == Status::ok);
}

TEST_CASE("where the lever of the file is short, nothing follows by it") {
  for (int k = 0; k <= 12; ++k) {
    const double length = std::pow(10.0, -k);
    const auto expected = trailer<Truth>(static_cast<long double>(length));
    const auto found = trailer<gauss::trailer_4::Tested>(length);
    INFO("l = 10^-" << k);
    CHECK(found.status == Status::ok);
    CHECK(difference(found.values, expected.values) < 1e-13);
  }
  CHECK(trailer<gauss::trailer_4::Tested>(0.0).status == Status::ok);
}

TEST_CASE("a moment of inertia that is nothing but rounding of a difference is none") {
  for (const double mass : {0.7, 0.8, 0.9, 1.0, 1.1, 1.2}) {
    INFO("m = " << mass);
    CHECK(of_rotor(mass, 0) == Status::singular_mass_matrix);
    CHECK(of_rotor(mass, 1e-6) == Status::ok);
  }
}

TEST_CASE("a moment of inertia beyond the largest number is in the status") {
  CHECK(of_two_bobs<TwoBobs>(1.0F, 1.0F, 1.0F, 0.5F) == Status::ok);
  CHECK(of_two_bobs<TwoBobs>(5.97e24F, 3.8e8F, 7e22F, 1e7F) != Status::ok);
  CHECK(of_two_bobs<TwoBobs>(5.97e24, 3.8e8, 7e22, 1e7) == Status::ok);
  CHECK(of_two_bobs<TwoBobsByMetric>(1.0, 1.0, 1.0, 0.5) == Status::ok);
  CHECK(of_two_bobs<TwoBobsByMetric>(1e200, 1e100, 1.0, 1.0) != Status::ok);
}

TEST_CASE("long chains are trusted in float, with its digits") {
  const Comparison planar = in_float<PlanarChain>();
  CHECK(planar.trusted == 50);
  CHECK(planar.worst < 1e-5);
  const Comparison spatial = in_float<SpatialChain>();
  CHECK(spatial.trusted == 50);
  CHECK(spatial.worst < 1e-3);
}

// Through light links a heavy end comes as a difference of large numbers, once for each of them.
TEST_CASE("where the tree loses digits that the metric keeps, the metric is taken") {
  const double on_tree = worst_when_aligned<HeavyHookOnTree>(), chosen = worst_when_aligned<HeavyHook>();
  INFO(on_tree << " on the tree, " << chosen << " as chosen");
  CHECK(on_tree > 1e-10);
  CHECK(chosen < 1e-2 * on_tree);
}
