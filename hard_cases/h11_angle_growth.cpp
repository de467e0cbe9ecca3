// An angle that grows by 1e5 rad in every second: where the rotor stands in the end.

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"
#include "spinning_rotor.hpp"

namespace hard_cases {

GAUSS_MODEL(SpinningRotor, gauss::spinning_rotor);

namespace {

constexpr double k_step = 0.01;

/// n k h modulo a turn, rad: of 1e11 rad, fifty digits leave 39.
double exact_angle(double n, std::int64_t k) {
  using Long = boost::multiprecision::cpp_bin_float_50;
  const Long turn = 2 * boost::math::constants::pi<Long>();
  return static_cast<double>(Long(fmod(Long(n) * Long(k_step) * Long(k), turn)));
}

/// Between two attitudes, rad.
double difference(double a, double b) {
  return std::abs(std::atan2(std::sin(a) * std::cos(b) - std::cos(a) * std::sin(b),
                             std::cos(a) * std::cos(b) + std::sin(a) * std::sin(b)));
}

struct Spin {
  double error = k_breaks_down;  ///< rad
  double seconds = 0;
};

template <class Model, class Stepper>
Spin spin(const Model& model, double rate, std::int64_t steps, Stepper stepper) {
  Stopwatch stopwatch;
  const gauss::spinning_rotor::State<double> start{{0, rate}};
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, k_step, 0, std::move(stepper));
  Spin result;
  if (run.advance(steps)) result.error = difference(run.state().values[0], exact_angle(rate, steps));
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace

std::vector<Figure> angle_growth(const Scope& scope) {
  const gauss::spinning_rotor::Parameters<double> parameters;
  const auto model = gauss::integrate::bind_model<SpinningRotor>(SpinningRotor::prepare(parameters),
                                                                 gauss::spinning_rotor::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  const std::int64_t steps = scope.is_long ? 100'000'000 : 1'000'000;
  const Spin naive = spin(model, parameters.n, steps, gauss::integrate::Rk4<Model>());
  std::vector<Figure> figures;
  const auto add = [&](const char* id, auto stepper) {
    stepper.wrap(0);
    const Spin ours = spin(model, parameters.n, steps, stepper);
    figures.push_back({id,
                       std::string("attitude after ") + (scope.is_long ? "1e6 s" : "1e4 s") + " at 1e5 rad/s",
                       "rad",
                       naive.error,
                       ours.error,
                       1e-9,
                       naive.seconds,
                       ours.seconds,
                       "",
                       {}});
  };
  add("H11.midpoint", gauss::integrate::GaussLegendre<Model, 1>());
  // Weights of 5/18 and 4/9, which are rounded.
  add("H11.order6", gauss::integrate::GaussLegendre<Model, 3>());
  return figures;
}

}  // namespace hard_cases
