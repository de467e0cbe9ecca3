// A knife edge that turns: whichever of its velocities is expressed by the other, cos or sin of its direction passes through zero.

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "chaplygin_sleigh.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/held_partition.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "knife_edge.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(KnifeEdge, gauss::knife_edge);
GAUSS_MODEL(Sleigh, gauss::chaplygin_sleigh);

namespace {

constexpr double k_half_pi = 1.5707963267948966, k_duration = 20;

/// y' = x' tan(phi) always, phi' = 1; the path is a circle of radius 1.
double dependent_y_always(double h) {
  struct State {
    double x, y, u;
  } s{0, 0, 1};
  const auto rate = [](const State& at, double t) { return State{at.u, at.u * std::tan(t), -at.u * std::tan(t)}; };
  const auto moved = [](const State& at, const State& by, double part) {
    return State{at.x + part * by.x, at.y + part * by.y, at.u + part * by.u};
  };
  double worst = 0;
  const auto steps = static_cast<long>(k_duration / h);
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * h;
    const State k1 = rate(s, t), k2 = rate(moved(s, k1, h / 2), t + h / 2), k3 = rate(moved(s, k2, h / 2), t + h / 2),
                k4 = rate(moved(s, k3, h), t + h);
    s = moved(moved(moved(moved(s, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
    const double after = static_cast<double>(k + 1) * h;
    const double error = std::hypot(s.x - std::sin(after), s.y - (1 - std::cos(after)));
    grow(worst, error);
  }
  return worst <= 1e300 ? worst : k_breaks_down;
}

double emitted(double h) {
  const auto prepared = KnifeEdge::prepare(gauss::knife_edge::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<KnifeEdge>(prepared, gauss::knife_edge::Inputs<double>{});
  using Rk4 = gauss::integrate::Rk4<std::decay_t<decltype(model)>>;
  gauss::simulate::FixedStep<std::decay_t<decltype(model)>, gauss::integrate::Projected<Rk4>> run(
      model, {{0, 0, 0, 1, 0, 1}}, h);
  double worst = 0;
  const bool arrives = run.advance(static_cast<std::int64_t>(k_duration / h), [&](double t, const auto& state) {
    const double error = std::hypot(state.values[0] - std::sin(t), state.values[1] - (1 - std::cos(t)));
    grow(worst, error);
  });
  return arrives ? worst : k_breaks_down;
}

struct Switching {
  double missed = k_breaks_down;      ///< switches, fewer or more than the rule gives
  double difference = k_breaks_down;  ///< of a component of the state, with and without
};

/// The same edge as a sleigh whose center of mass is at the blade: the generator cannot tell that this one never loses its rank, so the
/// header has the linear system to be eliminated.
Switching held_partition() {
  using System = gauss::chaplygin_sleigh::LinearSystem<double>;
  gauss::chaplygin_sleigh::Parameters<double> parameters;
  parameters.a = 0;
  parameters.m = parameters.Jc = 1;
  const auto model = gauss::integrate::bind_model<Sleigh>(parameters);
  using Model = std::decay_t<decltype(model)>;
  using ByParts = gauss::integrate::PartitionedModel<Model, System>;
  using Rk4 = gauss::integrate::Rk4<ByParts>;
  using Held = gauss::integrate::Projected<gauss::integrate::Held<Rk4, System>>;
  const auto rule = gauss::rank_of_velocities<double>(1);
  const gauss::chaplygin_sleigh::State<double> start{{0, 0, 0, 1, 0, 1}};
  constexpr double h = 0.001;
  gauss::simulate::FixedStep<Model, Held> held(model, start, h, 0, Held(gauss::integrate::Held<Rk4, System>(rule)));
  const ByParts chosen_at_every_call(model, rule);
  gauss::simulate::FixedStep<ByParts, gauss::integrate::Projected<Rk4>> pivoted(chosen_at_every_call, start, h);
  double difference = 0;
  for (int k = 0; k < 10'000; ++k) {
    if (!held.advance(1) || !pivoted.advance(1)) return {};
    for (int i = 0; i < 6; ++i) grow(difference, held.state().values[i] - pivoted.state().values[i]);
  }
  // Conditions are as |tan phi|: where it passes 2 or 1/2 on its way from 1, at phi = atan 2 + k pi/2, six times up to phi = 10.
  return {std::abs(static_cast<double>(held.stepper().inner().report().switches) - 6), difference};
}

}  // namespace

std::vector<Figure> knife_edge(const Scope&) {
  // The last three come to phi = pi/2 exactly.
  std::vector<double> steps;
  for (int i = 0; i < 47; ++i) steps.push_back(0.0005 + 0.00007 * i);
  for (const int parts : {400, 500, 1000}) steps.push_back(k_half_pi / parts);
  double naive = 0, ours = 0;
  Stopwatch of_naive;
  for (const double h : steps) naive = std::max(naive, dependent_y_always(h));
  const double seconds_naive = of_naive.seconds();
  Stopwatch of_ours;
  for (const double h : steps) ours = std::max(ours, emitted(h));
  const double seconds_ours = of_ours.seconds();
  Stopwatch of_switching;
  const Switching switching = held_partition();
  const double seconds_switching = of_switching.seconds();
  return {{"H02.path", "error of the place over 20 s, largest of 50 lengths of step", "m", naive, ours, 1e-9,
           seconds_naive, seconds_ours},
          {"H02.switches",
           "changes of the held dependent velocity in 10 rad, beside the 6 of the rule",
           "1",
           {},
           switching.missed,
           0,
           0,
           seconds_switching},
          {"H02.on_off",
           "largest difference over 10 s between a held choice and one at every call",
           "1",
           {},
           switching.difference,
           1e-11,
           0,
           seconds_switching}};
}

}  // namespace hard_cases
