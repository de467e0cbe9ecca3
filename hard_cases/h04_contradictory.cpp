// Constraints that contradict each other: refused when a model is read, and where parameters make them so by the positions, which no
// projection brings together; no motion comes of them.

#include <cmath>
#include <cstdio>

#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "process.hpp"
#include "registry.hpp"
#include "two_lengths.hpp"

namespace hard_cases {

GAUSS_MODEL(TwoLengths, gauss::two_lengths);

namespace {

namespace model = gauss::two_lengths;
constexpr int k_steps = 1000;

/// 0: the generator refuses the model with E080 and the names of both.
double generations() {
  const std::string text = "sed 's/k: {value: 1,/k: {value: 1.5,/' '" GAUSS_SOURCE_DIR
                           "/hard_cases/models/two_lengths.yaml' | '" GAUSS_GEN "' ";
  double accepted = 0;
  for (const char* command : {"--check -", "- -o -"}) {
    const Outcome outcome = run_program(text + command);
    const bool is_named = outcome.said.find("error[E080]") != std::string::npos &&
                          outcome.said.find("constraints 'first' and 'second' together") != std::string::npos;
    if (outcome.exit_code != 1 || !is_named) ++accepted;
  }
  return accepted;
}

/// Of 1 ms each, with a bar that the parameters made longer, or make grow.
template <class Stepper>
double steps_taken(const model::Parameters<double>& parameters) {
  const auto prepared = TwoLengths::prepare(parameters);
  const auto bound = gauss::integrate::bind_model<TwoLengths>(prepared, model::Inputs<double>{});
  const model::State<double> start{{0.6, -0.8, 0, 0}};
  gauss::simulate::FixedStep<std::decay_t<decltype(bound)>, Stepper> run(bound, start, 0.001);
  (void)run.advance(k_steps);
  return static_cast<double>(run.steps());
}

/// Of two runs, those in which projection does not say soon that the constraints contradict each other, or `mobility` does not name them.
double unnamed(const model::Parameters<double>& longer, const model::Parameters<double>& growing) {
  double result = 0;
  for (const auto& parameters : {longer, growing}) {
    const auto prepared = prepare(parameters);
    const model::State<double> start{{0.6, -0.8, 0, 0}};
    model::State<double> projected = start;
    model::Mobility<double> found{};
    const bool is_refused = project(0.01, start, prepared, projected) == gauss::Status::violated_constraints;
    (void)mobility(0.01, start, {}, prepared, found);
    if (!is_refused || found.is_shared[0] != 1 || found.is_shared[1] != 1) ++result;
  }
  return result;
}

/// Both rows averaged, as least squares without a test of the residual do: n·a = (mean of what each demands) along the bars, from there on by
/// Euler's method.
double steps_by_average(double demanded) {
  double x = 0.6, y = -0.8, vx = 0, vy = 0;
  int steps = 0;
  for (; steps < k_steps && std::isfinite(x + y); ++steps) {
    const double r = std::hypot(x, y), along = demanded / 2 - (vx * vx + vy * vy) / r;
    const double ax = x / r * (along + 9.81 * y / r), ay = y / r * (along + 9.81 * y / r) - 9.81;
    vx += 0.001 * ax, vy += 0.001 * ay;
    x += 0.001 * vx, y += 0.001 * vy;
  }
  return steps;
}

}  // namespace

std::vector<Figure> contradictory(const Scope&) {
  using Bound = std::decay_t<decltype(gauss::integrate::bind_model<TwoLengths>(
      TwoLengths::prepare(model::Parameters<double>{}), model::Inputs<double>{}))>;
  using Rk4 = gauss::integrate::Rk4<Bound>;
  model::Parameters<double> longer, growing;
  longer.k = 1.5;
  growing.w = 1;
  return {{"H04.generated",
           "of 2 commands, those that accept bars of 1 m and 1.5 m between two places, or do not name both", "1",
           std::nullopt, generations(), 0},
          {"H04.length", "steps of 1000, one bar longer than the other", "1", steps_by_average(0),
           steps_taken<gauss::integrate::Projected<Rk4>>(longer), 0},
          {"H04.growth", "steps of 1000, one bar growing beside the other", "1", steps_by_average(1),
           steps_taken<gauss::integrate::Projected<Rk4>>(growing), 0},
          {"H04.named", "of these 2, those without the status of contradiction, or whose rows 'mobility' does not name",
           "1", std::nullopt, unnamed(longer, growing), 0}};
}

}  // namespace hard_cases
