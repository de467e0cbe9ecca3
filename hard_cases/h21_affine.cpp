// Constraints of velocities that are not linear: rolling on a table that turns (affine, with terms that depend on the place), and a
// particle whose vertical speed is in proportion to its horizontal one (nonlinear, Appell and Hamel).

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "appell_hamel.hpp"
#include "appell_tilted.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"
#include "sphere_turntable.hpp"

namespace hard_cases {

GAUSS_MODEL(Turntable, gauss::sphere_turntable);
GAUSS_MODEL(Appell, gauss::appell_hamel);
GAUSS_MODEL(TiltedAppell, gauss::appell_tilted);

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
  // Virtual displacements by derivatives of places, as of equations of positions: this constraint has none, and exerts nothing.
  const auto free_fall = [=](double t) {
    return std::array<double, 3>{q0[0] + q0[3] * t, q0[1] + q0[4] * t, q0[2] - ratio * speed * t - p.g * t * t / 2};
  };
  return follow<Appell>(prepared, gauss::appell_hamel::Inputs<double>{}, start, exact, free_fall);
}

/// Where gravity has a part h along x, the way bends. With v = s (cos e, sin e) Gauss's principle leaves two equations,
/// (a^2 + b^2) s' = b^2 h cos e + a b g  and  s e' = -h sin e.
template <class Parameters>
auto bent_way(const Parameters& p, const double* q) {
  using Values = std::array<double, 5>;  // s, e, then the place
  return [p, y = Values{std::hypot(q[3], q[4]), std::atan2(q[4], q[3]), q[0], q[1], q[2]},
          method = boost::numeric::odeint::runge_kutta_fehlberg78<Values>(), last = 0.0](double t) mutable {
    const auto system = [&p](const Values& x, Values& rate, double) {
      const double a = p.a, b = p.b, c = std::cos(x[1]), s = std::sin(x[1]);
      rate = {(b * b * p.h * c + a * b * p.g) / (a * a + b * b), -p.h * s / x[0], x[0] * c, x[0] * s, -a / b * x[0]};
    };
    method.do_step(system, y, last, t - last);
    last = t;
    return std::array<double, 3>{y[2], y[3], y[4]};
  };
}

/// The formula for linear constraints, applied to the one with the coefficients of the start: its row c stays as it is, and the particle moves with
/// f - c (c f)/(c c).
template <class Parameters>
auto by_linear_formula(const Parameters& p, const double* q) {
  const double f[3] = {p.h, 0, -p.g};
  const double c[3] = {p.a * p.a * q[3], p.a * p.a * q[4], -p.b * p.b * q[5]};
  const double along = (c[0] * f[0] + c[2] * f[2]) / (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
  std::array<double, 3> x{}, v{}, a{};
  for (std::size_t i = 0; i < 3; ++i) x[i] = q[i], v[i] = q[3 + i], a[i] = f[i] - c[i] * along;
  return [=](double t) {
    std::array<double, 3> place{};
    for (std::size_t i = 0; i < 3; ++i) place[i] = x[i] + v[i] * t + a[i] * t * t / 2;
    return place;
  };
}

Errors tilted() {
  const gauss::appell_tilted::Parameters<double> p;
  const auto prepared = TiltedAppell::prepare(p);
  gauss::appell_tilted::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {0, k_breaks_down, 0, 1};
  return follow<TiltedAppell>(prepared, gauss::appell_tilted::Inputs<double>{}, start, bent_way(p, start.values),
                              by_linear_formula(p, start.values));
}

}  // namespace

std::vector<Figure> affine(const Scope&) {
  const Errors table = turntable(), particle = appell_hamel(), bent = tilted();
  return {{"H21.turntable", "way of a ball on a turntable in 20 s, naive without the table's turn", "m", table.naive,
           table.ours, 1e-10, 0, table.seconds},
          {"H21.appell", "way of Appell and Hamel's particle in 20 s, by its length", "1",
           particle.naive / particle.length, particle.ours / particle.length, 1e-10, 0, particle.seconds,
           "naive: virtual displacements by derivatives by places"},
          {"H21.bent", "the same where gravity bends its way", "1", bent.naive / bent.length, bent.ours / bent.length,
           1e-10, 0, bent.seconds, "naive: the formula for linear constraints, with the coefficients of the start"}};
}

}  // namespace hard_cases
