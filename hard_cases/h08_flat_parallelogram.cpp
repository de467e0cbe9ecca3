// A loop that passes through a position in which its constraints depend on each other: a parallelogram that lies in one line. From there it
// could go on as an anti-parallelogram, too.

#include <algorithm>
#include <cmath>

#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "parallelogram.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(Parallelogram, gauss::parallelogram);

namespace {

constexpr double k_crank = 1, k_gravity = 9.81, k_turn = 6.283185307179586;
constexpr double k_masses = 3 + 2.0 / 3;  ///< kg: the coupler, and a third of the crank and of the rocker
constexpr double k_weighed =
    3 + 2 * 0.5;  ///< kg m: the coupler at the end of the crank, crank and rocker at their middles

struct Run {
  double branch = 0;  ///< angle of the coupler, rad
  double energy = 0;  ///< relative
  long depending = 0;
  double turns = 0;
  double seconds = 0;
  Series series;
};

template <class Stepper, class Model>
Run run(const Model& model, const typename Model::State& start, std::int64_t steps, const char* name) {
  Stopwatch stopwatch;
  Run result;
  result.series.name = name;
  // A parallelogram by closed form: the coupler does not turn, and all mass centres rise with the crank.
  const auto energy_of = [](const double* y) {
    const double ends = k_crank * y[3];
    return k_masses / 2 * ends * ends + k_gravity * k_weighed * std::sin(y[0]);
  };
  const double first = energy_of(start.values);
  gauss::simulate::FixedStep<Model, Stepper> moving(model, start, 0.001);
  const bool arrives = moving.advance(steps, [&](double t, const auto& state) {
    grow(result.branch, state.values[0] + state.values[1]);
    grow(result.energy, (energy_of(state.values) - first) / first);
    if (moving.last().status != gauss::Status::ok) ++result.depending;
    if (moving.steps() % std::max<std::int64_t>(1, steps / 60) != 0) return;
    result.series.t.push_back(t);
    result.series.values.push_back(result.branch);
  });
  result.turns = (moving.state().values[0] - start.values[0]) / k_turn;
  if (!arrives || !(result.branch <= 1e300)) result.branch = result.energy = k_breaks_down;
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace

std::vector<Figure> flat_parallelogram(const Scope&) {
  const auto prepared = Parallelogram::prepare(gauss::parallelogram::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<Parallelogram>(prepared, gauss::parallelogram::Inputs<double>{});
  using Rk4 = gauss::integrate::Rk4<std::decay_t<decltype(model)>>;
  gauss::parallelogram::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {};
  const Run naive = run<Rk4>(model, start, 120'000, "rk4");
  const Run ours = run<gauss::integrate::Projected<Rk4>>(model, start, 120'000, "rk4, projected");
  const std::string remark = std::to_string(static_cast<int>(ours.turns)) + " turns, " +
                             std::to_string(ours.depending) + " steps with dependent constraints";
  std::vector<Figure> figures = {{"H08.branch", "turn of the coupler in 120 s", "rad", naive.branch, ours.branch, 1e-9,
                                  naive.seconds, ours.seconds, remark},
                                 {"H08.energy", "relative error of the energy", "1", naive.energy, ours.energy, 1e-4,
                                  naive.seconds, ours.seconds}};
  figures[0].charts = {naive.series, ours.series};

  // Flat to the last bit, and beside it.
  double worst = 0, branch = 0;
  for (const double off : {0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
    gauss::parallelogram::State<double> flat{{off, -off, off, k_turn, -k_turn, k_turn}};
    gauss::parallelogram::Derivative<double> derivative{};
    gauss::parallelogram::State<double> projected{};
    const gauss::Status status = rhs(0.0, flat, {}, prepared, derivative);
    const gauss::Status of_projection = project(0.0, flat, prepared, projected);
    for (const double value : derivative.values) {
      if (!std::isfinite(value)) worst = k_breaks_down;
    }
    if (!gauss::integrate::is_motion_known(status) || !gauss::integrate::is_motion_known(of_projection))
      worst = k_breaks_down;
    grow(branch, run<gauss::integrate::Projected<Rk4>>(model, projected, 1000, "from flat").branch);
    // Speeds are known to a millionth of a turn at best where positions to 1e-16 make such an angle.
    for (int i = 0; i < 3; ++i) grow(worst, projected.values[i] - flat.values[i]);
  }
  figures.push_back(
      {"H08.flat", "how far projection moves positions at and beside the flat one", "rad", std::nullopt, worst, 1e-9});
  figures.push_back({"H08.beside", "turn of the coupler in a second from these projected positions", "rad",
                     std::nullopt, branch, 1e-9});
  for (Figure& figure : even_crank()) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace hard_cases
