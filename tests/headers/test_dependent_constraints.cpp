// A constraint that is written twice, with different factors, leaves the multipliers open, and the status of whoever shows them has to
// say so. Accelerations are determined all the same, and so is the nearest state.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "catch_shim.hpp"
#include "chaplygin_sleigh.hpp"
#include "doubled_skate.hpp"

namespace {

namespace doubled = gauss::doubled_skate;
namespace single = gauss::chaplygin_sleigh;

template <class S>
void is_reported() {
  const auto prepared = doubled::prepare(doubled::Parameters<S>{});
  for (int i = 0; i < 2000; ++i) {
    const S theta = S(i) / S(100);
    const doubled::State<S> state{{S(1), S(2), theta, -std::cos(theta), -std::sin(theta), S(i % 7)}};
    doubled::Derivative<S> derivative{};
    doubled::Reactions<S> reactions{};
    doubled::State<S> projected{};
    INFO("theta = " << theta);
    CHECK(rhs(S(0), state, {}, prepared, derivative) == gauss::Status::ok);
    CHECK(doubled::reactions(S(0), state, {}, prepared, reactions) == gauss::Status::dependent_constraints);
    CHECK(rhs_and_reactions(S(0), state, {}, prepared, derivative, reactions) == gauss::Status::dependent_constraints);
    CHECK(project(S(0), state, prepared, projected) == gauss::Status::ok);
  }
}

}  // namespace

TEST_CASE(
    "a constraint that is stated twice is reported at every state, in every function that shows its multipliers") {
  is_reported<float>();
  is_reported<double>();
  is_reported<long double>();
}

// What is left of the second row is rounding. Divided by, it would make accelerations of any size.
TEST_CASE(
    "accelerations and projected speeds under a doubled constraint are those of the single one, and each row carries "
    "half of its force") {
  const auto twice = doubled::prepare(doubled::Parameters<double>{});
  const auto once = single::prepare(single::Parameters<double>{});
  double largest = 0;
  for (int i = 0; i < 2000; ++i) {
    const double theta = 0.01 * i;
    // Not on the constraint, so that the projection has something to do.
    const double y[] = {1, 2, theta, -std::cos(theta), 0.5 - std::sin(theta), 1.5};
    doubled::State<double> state{};
    single::State<double> expected_state{};
    std::copy(std::begin(y), std::end(y), state.values);
    std::copy(std::begin(y), std::end(y), expected_state.values);
    doubled::Derivative<double> derivative{};
    doubled::Reactions<double> reactions{};
    (void)rhs_and_reactions(0.0, state, {}, twice, derivative, reactions);
    doubled::State<double> projected{};
    (void)project(0.0, state, twice, projected);
    single::Derivative<double> expected{};
    single::Reactions<double> force{};
    (void)rhs_and_reactions(0.0, expected_state, {}, once, expected, force);
    single::State<double> expected_projected{};
    (void)project(0.0, expected_state, once, expected_projected);
    for (std::size_t k = 0; k < std::size(y); ++k) {
      largest = std::fmax(largest, std::fabs(derivative.values[k] - expected.values[k]));
      largest = std::fmax(largest, std::fabs(projected.values[k] - expected_projected.values[k]));
    }
    for (std::size_t k = 0; k < std::size(force.blade.generalized); ++k) {
      for (const double half : {reactions.blade.generalized[k], reactions.blade_again.generalized[k]})
        largest = std::fmax(largest, std::fabs(half - force.blade.generalized[k] / 2));
    }
  }
  // Values of order 1, conditions below 10: 100 kappa eps.
  CHECK(largest <= 1e-12);
}

TEST_CASE("the same constraint stated once is not reported") {
  const auto prepared = single::prepare(single::Parameters<double>{});
  for (int i = 0; i < 2000; ++i) {
    const double theta = 0.01 * i;
    const single::State<double> state{{1, 2, theta, -std::cos(theta), -std::sin(theta), 1.5}};
    single::Derivative<double> derivative{};
    INFO("theta = " << theta);
    CHECK(single::rhs(0.0, state, {}, prepared, derivative) == gauss::Status::ok);
  }
}
