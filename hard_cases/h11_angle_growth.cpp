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
/// With float, a step and a spin that it holds exactly: else it would be another motion.
constexpr float k_float_step = 0x1p-7F, k_float_spin = 100000.125F;

/// n k h modulo a turn, rad: of 1e11 rad, fifty digits leave 39.
template <class Scalar>
double exact_angle(Scalar n, Scalar h, std::int64_t k) {
  using Long = boost::multiprecision::cpp_bin_float_50;
  const Long turn = 2 * boost::math::constants::pi<Long>();
  return static_cast<double>(Long(fmod(Long(n) * Long(h) * Long(k), turn)));
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

template <class Model, class Stepper, class Scalar>
Spin spin(const Model& model, Scalar rate, Scalar step, std::int64_t steps, Stepper stepper) {
  Stopwatch stopwatch;
  const typename Model::State start{{0, rate}};
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, step, 0, std::move(stepper));
  Spin result;
  if (run.advance(steps))
    result.error = difference(static_cast<double>(run.state().values[0]), exact_angle(rate, step, steps));
  result.seconds = stopwatch.seconds();
  return result;
}

/// In float the angle itself has no digit of the attitude left after an hour; within a turn, and summed to twice the digits, it has all of them.
Figure in_float() {
  gauss::spinning_rotor::Parameters<float> parameters;
  parameters.n = k_float_spin;
  const auto model = gauss::integrate::bind_model<SpinningRotor, float>(parameters);
  using Model = std::decay_t<decltype(model)>;
  constexpr std::int64_t k_steps = 3600 * 128;
  const Spin naive = spin(model, k_float_spin, k_float_step, k_steps, gauss::integrate::Rk4<Model>());
  gauss::integrate::GaussLegendre<Model, 3> wrapped;
  wrapped.wrap(0);
  const Spin ours = spin(model, k_float_spin, k_float_step, k_steps, wrapped);
  return {
      "H11.float", "attitude after an hour at 1e5 rad/s, in float", "rad", naive.error, ours.error, 1e-6, naive.seconds,
      ours.seconds};
}

}  // namespace

std::vector<Figure> angle_growth(const Scope& scope) {
  const gauss::spinning_rotor::Parameters<double> parameters;
  const auto model = gauss::integrate::bind_model<SpinningRotor>(parameters);
  using Model = std::decay_t<decltype(model)>;
  const std::int64_t steps = scope.is_long ? 100'000'000 : 1'000'000;
  const Spin naive = spin(model, parameters.n, k_step, steps, gauss::integrate::Rk4<Model>());
  std::vector<Figure> figures;
  const auto add = [&](const char* id, auto stepper) {
    stepper.wrap(0);
    const Spin ours = spin(model, parameters.n, k_step, steps, stepper);
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
  figures.push_back(in_float());
  return figures;
}

}  // namespace hard_cases
