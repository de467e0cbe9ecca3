#include <cmath>

#include "catch_shim.hpp"
#include "doubled_skate.hpp"

#include "chaplygin_sleigh.hpp"

TEST_CASE("constraints that say the same twice are reported as dependent, at every state") {
  namespace model = gauss::doubled_skate;
  const auto prepared = model::prepare(model::Parameters<double>{});
  const auto single = gauss::chaplygin_sleigh::prepare(gauss::chaplygin_sleigh::Parameters<double>{});
  int reported = 0;
  for (int i = 0; i < 100; ++i) {
    const double theta = 0.1 * i;
    const model::State<double> state{{0.3, -0.2, theta, -std::cos(theta), -std::sin(theta), 1.5}};
    model::Derivative<double> derivative{};
    model::Reactions<double> reactions{};
    const gauss::Status status = model::rhs_and_reactions(0.0, state, {}, prepared, derivative, reactions);
    INFO("theta = " << theta << ": " << gauss::name(status));
    CHECK(status == gauss::Status::dependent_constraints);
    CHECK(model::rhs(0.0, state, {}, prepared, derivative) == status);
    CHECK(model::reactions(0.0, state, {}, prepared, reactions) == status);
    model::State<double> projected{};
    CHECK(model::project(0.0, state, prepared, projected) == status);
    ++reported;
    (void)single;
  }
  CHECK(reported == 100);
}
