// Loops in space that move although equations are as many as motions, or more: Bennett's linkage, which six equations close, of which two
// say something.

#include <algorithm>
#include <cmath>

#include "bennett.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(Bennett, gauss::bennett);

namespace {

struct Run {
  double gap = 0;     ///< m
  double energy = 0;  ///< relative
  double turns = 0;
  double seconds = 0;
};

template <class Stepper, class Model, class Prepared>
Run run(const Model& model, const Prepared& prepared, const typename Model::State& start, std::int64_t steps) {
  Stopwatch stopwatch;
  Run result;
  gauss::bennett::Energy<double> energy{};
  (void)gauss::bennett::energy(0.0, start, prepared, energy);
  const double first = energy.total;
  gauss::simulate::FixedStep<Model, Stepper> moving(model, start, 0.001);
  const bool arrives = moving.advance(steps, [&](double t, const auto& state) {
    gauss::bennett::Residuals<double> residuals{};
    (void)gauss::bennett::residuals(t, state, {}, prepared, {}, residuals);
    for (const double f : residuals.position) {
      grow(result.gap, f);
    }
    (void)gauss::bennett::energy(t, state, prepared, energy);
    grow(result.energy, energy.total / first - 1);
  });
  result.turns = (moving.state().values[0] - start.values[0]) / 6.283185307179586;
  if (!arrives || !(result.gap <= 1e300)) result.gap = result.energy = k_breaks_down;
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace

std::vector<Figure> bennett(const Scope&) {
  const auto prepared = Bennett::prepare(gauss::bennett::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<Bennett>(prepared, gauss::bennett::Inputs<double>{});
  using Rk4 = gauss::integrate::Rk4<std::decay_t<decltype(model)>>;
  gauss::bennett::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {};
  const Run naive = run<Rk4>(model, prepared, start, 120'000);
  const Run ours = run<gauss::integrate::Projected<Rk4>>(model, prepared, start, 120'000);
  const std::string remark = std::to_string(static_cast<int>(ours.turns)) + " turns";
  return {{"H09.closure", "largest gap in 120 s", "m", naive.gap, ours.gap, 1e-10, naive.seconds, ours.seconds, remark},
          {"H09.energy", "relative error of the energy", "1", std::nullopt, ours.energy, 1e-6}};
}

}  // namespace hard_cases
