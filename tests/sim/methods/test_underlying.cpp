// The order of the steppers behind methods that choose their steps.
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <cmath>

#include "catch_shim.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "problems.hpp"

namespace {

using S = long double;
using Model = gausssim::MotionModel<S>;
using Array = gausssim::Numbers<S>;
using problems::Kepler;
using namespace gauss::integrate;

template <class Stepper>
S error_after(int steps) {
  const Model model(Kepler<S>::functions());
  Model::State state{Kepler<S>::at(0)};
  Stepper stepper;
  const S h = 2 / S(steps);
  for (int k = 0; k < steps; ++k) REQUIRE(stepper.step(model, h * S(k), h, state).is_taken());
  return problems::distance(state.values, Kepler<S>::at(2));
}

template <class Stepper>
double order(int steps) {
  return static_cast<double>(std::log2(error_after<Stepper>(steps) / error_after<Stepper>(2 * steps)));
}

}  // namespace

TEST_CASE("the pairs of Odeint have the order that they claim, in steps of one length") {
  using CashKarp = ExplicitStepper<Model, boost::numeric::odeint::runge_kutta_cash_karp54<Array, S, Array, S>>;
  CHECK(order<Prince8<Model>>(48) == Approx(8).margin(0.3));
  CHECK(order<Fehlberg78<Model>>(48) == Approx(8).margin(0.3));
  CHECK(order<Dopri5<Model>>(160) == Approx(5).margin(0.3));
  CHECK(order<CashKarp>(160) == Approx(5).margin(0.3));
}
