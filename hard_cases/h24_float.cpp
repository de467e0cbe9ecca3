// Single precision: what rounds once (h23_rounding.cpp), and an hour of motion.

#include <cmath>

#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"
#include "simple_pendulum.hpp"

namespace hard_cases {

GAUSS_MODEL(FloatPendulum, gauss::simple_pendulum);

namespace {

struct Drift {
  double largest = 0;  ///< relative
  double seconds = 0;
  Series series = {};
};

/// The energy of a state of floats, in double, so that it shows the state and not its own rounding.
double energy_of(const gauss::simple_pendulum::State<float>& state) {
  gauss::simple_pendulum::State<double> exact;
  for (int i = 0; i < 2; ++i) exact.values[i] = static_cast<double>(state.values[i]);
  gauss::simple_pendulum::Energy<double> energy;
  const auto prepared = prepare(gauss::simple_pendulum::Parameters<double>{});
  return gauss::simple_pendulum::energy(0.0, exact, prepared, energy) == gauss::Status::ok ? energy.total
                                                                                           : k_breaks_down;
}

template <class Stepper, class Model>
Drift hour(const Model& model, float step, const char* name) {
  Drift result;
  result.series.name = name;
  gauss::simple_pendulum::State<float> start;
  if (initial_state(model.prepared(), start) != gauss::Status::ok) return {k_breaks_down, 0, {}};
  const double first = energy_of(start);
  const auto steps = static_cast<std::int64_t>(std::lround(3600 / static_cast<double>(step)));
  Stopwatch stopwatch;
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, step);
  const bool arrives = run.advance(steps, [&](float t, const auto& state) {
    if (run.steps() % 100 != 0) return;
    grow(result.largest, energy_of(state) / first - 1);
    if (run.steps() % (steps / 50) != 0) return;
    result.series.t.push_back(static_cast<double>(t));
    result.series.values.push_back(result.largest);
  });
  if (!arrives) result.largest = k_breaks_down;
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace

std::vector<Figure> single_precision(const Scope&) {
  const auto prepared = FloatPendulum::prepare(gauss::simple_pendulum::Parameters<float>{});
  const auto model = gauss::integrate::bind_model<FloatPendulum>(prepared, gauss::simple_pendulum::Inputs<float>{});
  using Model = std::decay_t<decltype(model)>;
  const Drift naive = hour<gauss::integrate::Rk4<Model>>(model, 0.0009765625F, "rk4, 1 ms");
  const Drift ours = hour<gauss::integrate::GaussLegendre<Model, 3>>(
      model, 0.0078125F, "Gauss-Legendre with sums to twice the digits, 8 ms");
  std::vector<Figure> result = rounding_in_float();
  result.push_back({"H24.hour",
                    "relative error of the energy in an hour, states in float; RK4: " + std::to_string(naive.largest),
                    "1",
                    std::nullopt,
                    ours.largest,
                    1e-3,
                    naive.seconds,
                    ours.seconds,
                    "",
                    {naive.series, ours.series}});
  return result;
}

}  // namespace hard_cases
