// Constraints of velocities that are not linear: rolling on a table that turns (affine, with terms that depend on the place), and a
// particle whose vertical speed is in proportion to its horizontal one (nonlinear, Appell and Hamel).

#include <array>
#include <cmath>

#include "appell_hamel.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"
#include "sphere_turntable.hpp"

namespace hard_cases {

GAUSS_MODEL(Turntable, gauss::sphere_turntable);
GAUSS_MODEL(Appell, gauss::appell_hamel);

namespace {

constexpr double k_step = 1e-3;
constexpr std::int64_t k_steps = 20'000;

struct Errors {
  double naive = 0;    ///< m
  double ours = 0;     ///< m
  double seconds = 0;  ///< of ours
  double length = 0;   ///< m: farthest place
};

/// Follows the emitted model; `exact(t)` and `naive(t)` are places of as many coordinates as the model has.
template <class Source, class Prepared, class Inputs, class State, class Exact, class Naive>
Errors follow(const Prepared& prepared, const Inputs& inputs, const State& start, Exact&& exact, Naive&& naive) {
  const auto model = gauss::integrate::bind_model<Source>(prepared, inputs);
  using Model = std::decay_t<decltype(model)>;
  Errors result;
  Stopwatch stopwatch;
  gauss::simulate::FixedStep<Model, gauss::integrate::Prince8<Model>> run(model, start, k_step);
  const bool arrives = run.advance(k_steps, [&](double t, const auto& state) {
    const auto right = exact(t), simple = naive(t);
    for (std::size_t i = 0; i < right.size(); ++i) {
      grow(result.length, right[i]);
      grow(result.ours, state.values[i] - right[i]);
      grow(result.naive, simple[i] - right[i]);
    }
  });
  if (!arrives) result.ours = k_breaks_down;
  result.seconds = stopwatch.seconds();
  return result;
}

/// The velocity of the centre turns with 2/7 of the rate of the table (Earnshaw 1844): moments about the contact give
/// m r^2 (1 + 2/5) v' = J Omega e_z × v.
Errors turntable() {
  const gauss::sphere_turntable::Parameters<double> p;
  const auto prepared = Turntable::prepare(p);
  gauss::sphere_turntable::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {0, k_breaks_down, 0, 1};
  gauss::sphere_turntable::Derivative<double> rate;
  if (rhs(0.0, start, gauss::sphere_turntable::Inputs<double>{}, prepared, rate) != gauss::Status::ok)
    return {0, k_breaks_down, 0, 1};
  const double x = start.values[0], y = start.values[1], vx = rate.values[0], vy = rate.values[1], w = 2 * p.Omega / 7;
  const auto exact = [=](double t) {
    const double s = std::sin(w * t) / w, c = (1 - std::cos(w * t)) / w;
    return std::array<double, 2>{x + vx * s - vy * c, y + vy * s + vx * c};
  };
  // Constraints of a table at rest, shifted by its velocity: nothing turns v.
  const auto linear = [=](double t) { return std::array<double, 2>{x + vx * t, y + vy * t}; };
  return follow<Turntable>(prepared, gauss::sphere_turntable::Inputs<double>{}, start, exact, linear);
}

/// a |v| = -b z' with v = (x', y'): Gauss's principle keeps the direction of v, and |v|' = g (a/b)/(1 + (a/b)^2).
Errors appell_hamel() {
  const gauss::appell_hamel::Parameters<double> p;
  const auto prepared = Appell::prepare(p);
  gauss::appell_hamel::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {0, k_breaks_down, 0, 1};
  const double* q = start.values;
  const double speed = std::hypot(q[3], q[4]), ratio = p.a / p.b;
  const auto along = [=](double t) { return speed * t + p.g * ratio / (1 + ratio * ratio) * t * t / 2; };
  const std::array<double, 5> q0 = {q[0], q[1], q[2], q[3], q[4]};
  const auto exact = [=](double t) {
    const double s = along(t);
    return std::array<double, 3>{q0[0] + q0[3] / speed * s, q0[1] + q0[4] / speed * s, q0[2] - ratio * s};
  };
  return follow<Appell>(prepared, gauss::appell_hamel::Inputs<double>{}, start, exact, exact);
}

}  // namespace

std::vector<Figure> affine(const Scope&) {
  const Errors table = turntable(), particle = appell_hamel();
  return {{"H21.turntable", "way of a ball on a turntable in 20 s, naive without the table's turn", "m", table.naive,
           table.ours, 1e-10, 0, table.seconds},
          {"H21.appell", "way of Appell and Hamel's particle in 20 s, by its length", "1", std::nullopt,
           particle.ours / particle.length, 1e-10, 0, particle.seconds}};
}

}  // namespace hard_cases
