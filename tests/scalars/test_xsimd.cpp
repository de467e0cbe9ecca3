#include <limits>

#include "catch_shim.hpp"
#include "gauss/scalar/xsimd.hpp"

#include "nasty.hpp"
#include "pendulum.hpp"
#include "springs.hpp"
#include "zoo.hpp"

namespace {

template <class T>
using Batch = xsimd::batch<T>;

template <class T>
Batch<T> ramp(T first, T step) {
  T values[Batch<T>::size];
  for (std::size_t i = 0; i < Batch<T>::size; ++i) values[i] = first + step * static_cast<T>(i);
  return Batch<T>::load_unaligned(values);
}

template <class T>
void check_lanes() {
  using S = Batch<T>;
  namespace model = gauss::pendulum;
  const auto prepared = model::prepare(model::Parameters<S>{});
  const auto scalar_prepared = model::prepare(model::Parameters<T>{});
  const model::State<S> state{{ramp<T>(T(0.1), T(0.7)), ramp<T>(T(-1), T(0.3))}};
  model::Derivative<S> derivative;
  model::Reactions<S> reactions;
  const auto status = model::rhs_and_reactions(S(T(0)), state, model::Inputs<S>{}, prepared, derivative, reactions);
  CHECK_FALSE(status.any());
  for (std::size_t i = 0; i < S::size; ++i) {
    const model::State<T> lane{{state.values[0].get(i), state.values[1].get(i)}};
    model::Derivative<T> expected{};
    model::Reactions<T> expected_reactions{};
    (void)model::rhs_and_reactions(T(0), lane, model::Inputs<T>{}, scalar_prepared, expected, expected_reactions);
    CHECK(derivative.theta_ddot().get(i) == Approx(expected.theta_ddot()));
    CHECK(reactions.rod.tension.get(i) == Approx(expected_reactions.rod.tension));
  }
}

}  // namespace

TEST_CASE("each lane of a batch has the result of the scalar computation") {
  check_lanes<double>();
  check_lanes<float>();
}

TEST_CASE("a lane that fails is reported and leaves the others alone") {
  using S = Batch<double>;
  namespace model = gauss::pendulum;
  const auto prepared = model::prepare(model::Parameters<S>{});
  double torque[S::size] = {};
  torque[1] = std::numeric_limits<double>::infinity();
  model::Inputs<S> inputs;
  inputs.torque = S::load_unaligned(torque);
  model::Derivative<S> derivative;
  const auto status = model::rhs(S(0.0), {{S(0.1), S(0.2)}}, inputs, prepared, derivative);
  CHECK(status.any());
  CHECK(status.lane(0) == gauss::Status::ok);
  CHECK(status.lane(1) == gauss::Status::not_finite);
  CHECK(derivative.theta_ddot().get(0) == Approx(-9.81 * std::sin(0.1) / 0.7));
}

TEST_CASE("lanes choose for themselves") {
  using S = Batch<double>;
  namespace model = models::zoo;
  const auto prepared = model::prepare(model::Parameters<S>{});
  const S x = ramp(-0.5, 1.0);
  const S y = S(0.25);
  model::Conditions<S> chosen;
  const auto status = model::conditions(S(0.0), {{x, y}}, model::Inputs<S>{}, prepared, chosen);
  for (std::size_t i = 0; i < S::size; ++i) {
    const double a = x.get(i);
    CHECK(chosen.smaller.get(i) == std::min(a, 0.25));
    CHECK(chosen.chosen.get(i) == a * 0.25);
    CHECK(status.singular_mass_matrix.get(i) == (a < 0.25));
  }
}

TEST_CASE("every function has its form for batches") {
  using S = Batch<double>;
  namespace model = models::zoo;
  const model::State<S> state{{S(0.5), S(0.75)}};
  const model::State<double> scalar{{0.5, 0.75}};
  model::Functions<S> f;
  model::Functions<double> expected{};
  (void)model::functions(S(0.0), state, {}, model::prepare(model::Parameters<S>{}), f);
  (void)model::functions(0.0, scalar, {}, model::prepare(model::Parameters<double>{}), expected);
  for (int i = 0; i < 12; ++i) CHECK(f.value[i].get(0) == Approx(expected.value[i]));
  model::Powers<S> p;
  model::Powers<double> expected_powers{};
  (void)model::powers(S(0.0), state, {}, model::prepare(model::Parameters<S>{}), p);
  (void)model::powers(0.0, scalar, {}, model::prepare(model::Parameters<double>{}), expected_powers);
  for (int i = 0; i < 15; ++i) CHECK(p.of_x[i].get(0) == Approx(expected_powers.of_x[i]));
}

TEST_CASE("the status of a lane is that of a scalar, and a lane with any condition is bad") {
  using S = Batch<double>;
  using M = gauss::Math<S>;
  CHECK(M::epsilon().get(0) == std::numeric_limits<double>::epsilon());
  using Bool = M::Bool;
  const Bool all(true);
  const Bool none(false);
  for (unsigned conditions = 0; conditions < 16; ++conditions) {
    const bool a = (conditions & 1U) != 0, b = (conditions & 2U) != 0, c = (conditions & 4U) != 0,
               d = (conditions & 8U) != 0;
    CHECK(M::status(Bool(a), Bool(b), Bool(c), Bool(d)).lane(0) == gauss::Math<double>::status(a, b, c, d));
  }
  CHECK(M::status(all, none, none, none).any());
  CHECK(M::status(none, all, none, none).any());
  CHECK(M::status(none, none, all, none).any());
  CHECK(M::status(none, none, none, all).any());
  CHECK_FALSE(M::status(none, none, none, none).any());
  CHECK(M::at_most(S(1.0), S(1.0)).get(0));
  CHECK_FALSE(M::at_most(S(2.0), S(1.0)).get(0));
  CHECK_FALSE(M::less(S(1.0), S(1.0)).get(0));
  CHECK(M::not_finite(S(1.0), S(1.0), S(std::numeric_limits<double>::infinity())).get(0));
}
