// A start that misses the constraints by little, by much and by far: assembled with a report, or refused, but never taken silently.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/assembly.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "pendulum_cartesian.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(Bob, gauss::pendulum_cartesian);

namespace {

/// m and m/s: length of the bar and speed along it, by formulas of their own.
double violation(const double* y) {
  const double radius = std::hypot(y[0], y[1]);
  return std::max(std::abs(radius - 1), std::abs((y[0] * y[2] + y[1] * y[3]) / radius));
}

}  // namespace

std::vector<Figure> ill_start(const Scope&) {
  const auto prepared = Bob::prepare(gauss::pendulum_cartesian::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<Bob>(prepared, gauss::pendulum_cartesian::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  std::vector<Figure> figures;
  for (const auto& [id, miss] : {std::pair<const char*, double>{"H30.1e-9", 1e-9}, {"H30.1e-3", 1e-3}, {"H30.1", 1}}) {
    gauss::pendulum_cartesian::State<double> start;
    if (initial_state(prepared, start) != gauss::Status::ok) return {};
    for (double& value : start.values) value += miss;
    gauss::simulate::FixedStep<Model, gauss::integrate::Rk4<Model>> naive(model, start, 0.001);
    const bool is_silent = naive.advance(1000);
    const auto assembly = gauss::simulate::assemble(model, 0.0, start, 0.5);
    const bool is_assembled = assembly.outcome == gauss::simulate::AssemblyOutcome::assembled;
    Figure figure{id, "violation after assembly, limit of moves 0.5", "m, m/s", {}};
    figure.bar = 1e-12;
    if (is_silent) figure.naive = violation(naive.state().values);
    // A refusal is the right answer beyond the limit only.
    figure.ours = is_assembled ? violation(start.values) : miss > 0.5 ? 0 : k_breaks_down;
    char text[64];
    std::snprintf(text, sizeof text, "%s, component %d by %.2g", name(assembly.outcome),
                  static_cast<int>(assembly.component), assembly.largest);
    figure.remark = text;
    figures.push_back(figure);
  }
  return figures;
}

}  // namespace hard_cases
