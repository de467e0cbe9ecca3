// The order of the steppers behind methods that choose their steps.
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <cmath>
#include <string>

#include "catch_shim.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "problems.hpp"
#include "sim/drive/odeint_numbers.hpp"

namespace {

using S = long double;
using Model = gausssim::MotionModel<S>;
using Array = gausssim::Numbers<S>;
using namespace gauss::integrate;

template <class Problem, class Stepper>
S error_after(int steps) {
  const Model model(Problem::functions());
  Model::State state{Problem::at(0)};
  Stepper stepper;
  const S h = 2 / S(steps);
  for (int k = 0; k < steps; ++k) REQUIRE(stepper.step(model, h * S(k), h, state).is_taken());
  return problems::distance(state.values, Problem::at(2));
}

template <class Problem, class Stepper>
double order(int steps) {
  return static_cast<double>(
      std::log2(error_after<Problem, Stepper>(steps) / error_after<Problem, Stepper>(2 * steps)));
}

template <class Stepper>
void has_order(const std::string& name, int claimed, int steps) {
  const double in_place = order<problems::Kepler<S>, Stepper>(steps);
  const double in_time = order<problems::Driven<S>, Stepper>(steps / 2);
  CAPTURE(name, in_place, in_time);
  CHECK(in_place == Approx(claimed).margin(0.3));
  CHECK(in_time == Approx(claimed).margin(0.3));
}

}  // namespace

TEST_CASE("the pairs of Odeint have the order that they claim, in steps of one length") {
  using CashKarp = ExplicitStepper<Model, boost::numeric::odeint::runge_kutta_cash_karp54<Array, S, Array, S>>;
  has_order<Prince8<Model>>("prince87", 8, 48);
  has_order<Fehlberg78<Model>>("fehlberg78", 8, 48);
  has_order<Dopri5<Model>>("dopri5", 5, 160);
  has_order<CashKarp>("cash_karp54", 5, 160);
}
