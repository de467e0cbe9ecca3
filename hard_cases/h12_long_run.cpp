// Energy over 1e6 steps and more: a method that loses a little at each step, and a symplectic one.

#include <algorithm>
#include <cmath>

#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/nystrom_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"
#include "simple_pendulum.hpp"

namespace hard_cases {

GAUSS_MODEL(SimplePendulum, gauss::simple_pendulum);

namespace {

struct Energies {
  double tenths[10] = {};  ///< largest relative errors
  Series series;
  double seconds = 0;

  double largest() const { return *std::max_element(tenths, tenths + 10); }
  double growth() const { return tenths[9] / tenths[0]; }
};

template <class Stepper, class Model>
Energies energies(const Model& model, const typename Model::State& start, std::int64_t steps, const char* name) {
  constexpr double k_step = 0.01;
  Stopwatch stopwatch;
  Energies result;
  result.series.name = name;
  gauss::simple_pendulum::Energy<double> energy;
  if (model.energy(0.0, start, energy) != gauss::Status::ok) return result;
  const double first = energy.total;
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, k_step);
  const std::int64_t tenth = steps / 10;
  const bool arrives = run.advance(steps, [&](double t, const auto& state) {
    model.energy(t, state, energy);
    const std::int64_t k = run.steps() - 1;
    const double error = std::abs((energy.total - first) / first);
    double& largest = result.tenths[std::min<std::int64_t>(9, k / tenth)];
    if (!(error <= largest)) largest = error;
    if (k % (steps / 50) != 0) return;
    result.series.t.push_back(t);
    result.series.values.push_back(largest);
  });
  if (!arrives) result.tenths[9] = k_breaks_down;
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace

std::vector<Figure> long_run(const Scope& scope) {
  const auto prepared = SimplePendulum::prepare(gauss::simple_pendulum::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<SimplePendulum>(prepared, gauss::simple_pendulum::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  gauss::simple_pendulum::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {};
  const std::int64_t steps = scope.is_long ? 100'000'000 : 1'000'000;
  const Energies naive = energies<gauss::integrate::Rk4<Model>>(model, start, steps, "rk4");
  const Energies ours = energies<gauss::integrate::McLachlan4<Model>>(model, start, steps, "McLachlan, order 4");
  const std::string duration = scope.is_long ? "1e6 s" : "1e4 s";
  return {{"H12.energy",
           "relative error of the energy in " + duration,
           "1",
           naive.largest(),
           ours.largest(),
           1e-7,
           naive.seconds,
           ours.seconds,
           "",
           {naive.series, ours.series}},
          {"H12.growth",
           "largest error of the last tenth by that of the first",
           "1",
           naive.growth(),
           ours.growth(),
           1.2,
           naive.seconds,
           ours.seconds,
           "",
           {}}};
}

}  // namespace hard_cases
