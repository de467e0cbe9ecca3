// A loop that closes on a link of a tree, stated twice: the row that follows from the other is dropped there, and the status says so.

#include <algorithm>
#include <cmath>

#include "catch_shim.hpp"
#include "doubled_linkage_on_arm.hpp"
#include "linkage_on_arm.hpp"

namespace {

namespace doubled = gauss::doubled_linkage_on_arm;
namespace single = gauss::linkage_on_arm;

constexpr int k_states = 2000;

/// Arm, crank and rocker, apart from where the rod is parallel to a link.
template <class State>
State state_at(int i) {
  State state{};
  const double values[] = {0.01 * i, 0.5 + 0.003 * i, 0.9 + 0.0007 * i, 1.1, -0.4, 0.3 + 0.001 * i};
  for (std::size_t k = 0; k < std::size(values); ++k)
    state.values[k] = static_cast<std::decay_t<decltype(state.values[k])>>(values[k]);
  return state;
}

template <class S>
void is_reported() {
  const auto prepared = doubled::prepare(doubled::Parameters<S>{});
  for (int i = 0; i < k_states; ++i) {
    INFO("state " << i);
    doubled::Derivative<S> derivative{};
    CHECK(doubled::rhs(S(0), state_at<doubled::State<S>>(i), {}, prepared, derivative) ==
          gauss::Status::dependent_constraints);
  }
}

}  // namespace

TEST_CASE("a loop on a link that is stated twice is reported at every state") {
  is_reported<float>();
  is_reported<double>();
  is_reported<long double>();
}

TEST_CASE("accelerations with a loop stated twice are those with one, and one multiplier is zero") {
  const auto twice = doubled::prepare(doubled::Parameters<double>{});
  const auto once = single::prepare(single::Parameters<double>{});
  double largest = 0;
  for (int i = 0; i < k_states; ++i) {
    INFO("state " << i);
    doubled::Derivative<double> derivative{};
    doubled::Reactions<double> reactions{};
    (void)doubled::rhs_and_reactions(0.0, state_at<doubled::State<double>>(i), {}, twice, derivative, reactions);
    single::Derivative<double> expected{};
    CHECK(single::rhs(0.0, state_at<single::State<double>>(i), {}, once, expected) == gauss::Status::ok);
    double size = 1;
    for (const double value : expected.values) size = std::fmax(size, std::fabs(value));
    for (std::size_t k = 0; k < std::size(expected.values); ++k)
      largest = std::fmax(largest, std::fabs(derivative.values[k] - expected.values[k]) / size);
    CHECK(reactions.rod.multiplier * reactions.rod_again.multiplier == 0);
  }
  CHECK(largest <= 1e-12);
}
