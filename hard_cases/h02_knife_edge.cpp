// A knife edge that turns: whichever of its velocities is expressed by the other, cos or sin of its direction passes through zero.

#include <algorithm>
#include <cmath>
#include <vector>

#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "knife_edge.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(KnifeEdge, gauss::knife_edge);

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
  return {{"H02.path", "error of the place over 20 s, largest of 50 lengths of step", "m", naive, ours, 1e-9,
           seconds_naive, of_ours.seconds()}};
}

}  // namespace hard_cases
