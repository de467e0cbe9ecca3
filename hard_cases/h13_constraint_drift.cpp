// Constraints that are kept by their second derivative alone drift off with the square of time; projection holds them.

#include <algorithm>
#include <cmath>

#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/stabilised.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "pendulum_cartesian.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(Bob, gauss::pendulum_cartesian);

namespace {

constexpr double k_length = 1;
constexpr double k_gravity = 9.81;

struct Misses {
  double position = 0;  ///< m
  double velocity = 0;  ///< m/s, along the bar
  double energy = 0;    ///< relative
  Series series;
  double seconds = 0;
};

/// By formulas of its own: the emitted functions are on trial.
double total_energy(const double* y) { return (y[2] * y[2] + y[3] * y[3]) / 2 + k_gravity * y[1]; }

void measure(const double* y, double first, Misses& misses) {
  const double radius = std::hypot(y[0], y[1]);
  grow(misses.position, radius - k_length);
  grow(misses.velocity, (y[0] * y[2] + y[1] * y[3]) / radius);
  grow(misses.energy, (total_energy(y) - first) / first);
}

template <class Stepper, class Model>
Misses misses(const Model& model, const typename Model::State& start, std::int64_t steps, const char* name) {
  Stopwatch stopwatch;
  Misses result;
  result.series.name = name;
  const double first = total_energy(start.values);
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, 0.001);
  const bool arrives = run.advance(steps, [&](double t, const auto& state) {
    measure(state.values, first, result);
    if (run.steps() % (steps / 50) != 0) return;
    result.series.t.push_back(t);
    result.series.values.push_back(result.position);
  });
  if (!arrives) result.position = result.velocity = result.energy = k_breaks_down;
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace

std::vector<Figure> constraint_drift(const Scope&) {
  const auto prepared = Bob::prepare(gauss::pendulum_cartesian::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<Bob>(prepared, gauss::pendulum_cartesian::Inputs<double>{});
  using Rk4 = gauss::integrate::Rk4<std::decay_t<decltype(model)>>;
  gauss::pendulum_cartesian::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {};
  constexpr std::int64_t k_steps = 10'000'000;
  const Misses naive = misses<Rk4>(model, start, k_steps, "rk4");
  const Misses ours = misses<gauss::integrate::Projected<Rk4>>(model, start, k_steps, "rk4, projected");
  const auto figure = [&](const char* id, const char* quantity, const char* unit, double Misses::*member, double bar) {
    return Figure{id, quantity, unit, naive.*member, ours.*member, bar, naive.seconds, ours.seconds, "", {}};
  };
  std::vector<Figure> figures = {figure("H13.position", "length of the bar in 1e4 s", "m", &Misses::position, 1e-12),
                                 figure("H13.velocity", "speed along the bar", "m/s", &Misses::velocity, 1e-12),
                                 figure("H13.energy", "relative error of the energy", "1", &Misses::energy, 1e-8)};
  // What gains do instead: for the record, beside the bars that the catalogue measured for them.
  using Pulled =
      gauss::integrate::Stabilised<std::decay_t<decltype(model)>, gauss::pendulum_cartesian::Residuals<double>,
                                   gauss::pendulum_cartesian::LinearSystem<double>>;
  const Misses pulled =
      misses<gauss::integrate::Rk4<Pulled>>(Pulled(model, {5, 5}, 1), start, k_steps, "rk4, gains of 5/s");
  const auto by_gains = [&](const char* id, const char* quantity, double Misses::*member, double bar) {
    return Figure{id,
                  quantity,
                  "1",
                  naive.*member,
                  pulled.*member,
                  bar,
                  naive.seconds,
                  pulled.seconds,
                  "ours: Baumgarte's gains of 5/s instead of projection",
                  {}};
  };
  figures.push_back(by_gains("H13.gains", "relative length of the bar in 1e4 s", &Misses::position, 1e-11));
  figures.push_back(by_gains("H13.gains_energy", "relative error of the energy", &Misses::energy, 1e-7));
  figures[0].charts = {naive.series, pulled.series, ours.series};
  return figures;
}

}  // namespace hard_cases
