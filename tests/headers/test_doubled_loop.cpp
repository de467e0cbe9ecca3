// A loop that closes on a link of a tree, stated twice: the motion is that of one, and the status of reactions says that they are not unique.

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
    doubled::Reactions<S> reactions{};
    CHECK(doubled::reactions(S(0), state_at<doubled::State<S>>(i), {}, prepared, reactions) ==
          gauss::Status::dependent_constraints);
  }
}

}  // namespace

TEST_CASE("a loop on a link that is stated twice is reported at every state") {
  is_reported<float>();
  is_reported<double>();
  is_reported<long double>();
}

TEST_CASE("accelerations with a loop stated twice are those with one, and each row carries half of its force") {
  const auto twice = doubled::prepare(doubled::Parameters<double>{});
  const auto once = single::prepare(single::Parameters<double>{});
  double largest = 0;
  for (int i = 0; i < k_states; ++i) {
    INFO("state " << i);
    doubled::Derivative<double> derivative{};
    doubled::Reactions<double> reactions{};
    (void)doubled::rhs_and_reactions(0.0, state_at<doubled::State<double>>(i), {}, twice, derivative, reactions);
    doubled::Derivative<double> alone{};
    CHECK(doubled::rhs(0.0, state_at<doubled::State<double>>(i), {}, twice, alone) == gauss::Status::ok);
    single::Derivative<double> expected{};
    single::Reactions<double> force{};
    CHECK(single::rhs_and_reactions(0.0, state_at<single::State<double>>(i), {}, once, expected, force) ==
          gauss::Status::ok);
    double size = 1;
    for (const double value : expected.values) size = std::fmax(size, std::fabs(value));
    for (std::size_t k = 0; k < std::size(expected.values); ++k)
      largest = std::fmax(largest, std::fabs(derivative.values[k] - expected.values[k]) / size);
    for (const double half : {reactions.rod.multiplier, 3 * reactions.rod_again.multiplier})
      largest = std::fmax(largest, std::fabs(half - force.rod.multiplier / 2) / size);
  }
  CHECK(largest <= 1e-12);
}
