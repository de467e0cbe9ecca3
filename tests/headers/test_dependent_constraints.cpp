// A constraint that is written twice, with different factors, leaves the multipliers open. The accelerations would be
// determined, but elimination by the multiplier form divides by what is left of the second row, which is rounding; so
// the status has to say that nothing here is to be trusted.

#include <cmath>

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
    CHECK(rhs(S(0), state, {}, prepared, derivative) == gauss::Status::dependent_constraints);
    CHECK(doubled::reactions(S(0), state, {}, prepared, reactions) == gauss::Status::dependent_constraints);
    CHECK(rhs_and_reactions(S(0), state, {}, prepared, derivative, reactions) == gauss::Status::dependent_constraints);
    CHECK(project(S(0), state, prepared, projected) == gauss::Status::dependent_constraints);
  }
}

}  // namespace

TEST_CASE("a constraint that is stated twice is reported at every state, in every function that solves for it") {
  is_reported<float>();
  is_reported<double>();
  is_reported<long double>();
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
