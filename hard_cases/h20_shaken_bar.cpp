// The length of a bar whose pivot shakes, as an equation that contains time: its second derivative has terms that are easily lost.

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"
#include "shaken_bob.hpp"

namespace hard_cases {

GAUSS_MODEL(ShakenBob, gauss::shaken_bob);

namespace {

using Parameters = gauss::shaken_bob::Parameters<double>;
using State = gauss::shaken_bob::State<double>;

constexpr double k_step = 1e-4;
constexpr std::int64_t k_steps = 20'000;

/// Of the pivot, u = stroke sin(Omega t).
struct Pivot {
  double place, speed, acceleration;
};
Pivot pivot(const Parameters& p, double t) {
  const double angle = p.Omega * t;
  return {p.stroke * std::sin(angle), p.stroke * p.Omega * std::cos(angle),
          -p.stroke * p.Omega * p.Omega * std::sin(angle)};
}

/// At the end of the run.
template <class Values, class System>
Values integrated(Values values, System&& system) {
  boost::numeric::odeint::runge_kutta_fehlberg78<Values> method;
  for (std::int64_t k = 0; k < k_steps; ++k) method.do_step(system, values, static_cast<double>(k) * k_step, k_step);
  return values;
}

/// From the vertical: theta'' = -(g sin theta + u'' cos theta)/L, moments about the pivot in axes that move with it.
double angle_by_minimal_model(const Parameters& p, const State& start) {
  using Pair = std::array<double, 2>;
  const Pair first = {std::atan2(start.values[0], -start.values[1]), 0};
  return integrated(first, [&](const Pair& x, Pair& rate, double t) {
    rate[0] = x[1];
    rate[1] = -(p.g * std::sin(x[0]) + pivot(p, t).acceleration * std::cos(x[0])) / p.L;
  })[0];
}

/// Shares of the terms of f'' = 0 that f's dependence on time brings in: 2 q' f_qt and f_tt.
struct Shares {
  double mixed, by_time;
};

/// With f = ((x - u)^2 + z^2 - L^2)/2 and b its gradient: b a + q' f_qq q' + 2 q' f_qt + f_tt = 0 determines the multiplier of b.
double angle_by_hand(const Parameters& p, const State& start, const Shares& shares) {
  using Four = std::array<double, 4>;
  const Four end = integrated(Four{start.values[0], start.values[1], start.values[2], start.values[3]},
                              [&](const Four& y, Four& rate, double t) {
                                const Pivot u = pivot(p, t);
                                const double b[2] = {y[0] - u.place, y[1]};
                                const double drift = y[2] * y[2] + y[3] * y[3] - shares.mixed * 2 * y[2] * u.speed +
                                                     shares.by_time * (u.speed * u.speed - b[0] * u.acceleration);
                                const double force = -(drift - b[1] * p.g) / (b[0] * b[0] + b[1] * b[1]);
                                rate = {y[2], y[3], b[0] * force, b[1] * force - p.g};
                              });
  return std::atan2(end[0] - pivot(p, k_steps * k_step).place, -end[1]);
}

double size(double difference) {
  double result = 0;
  grow(result, difference);
  return result;
}

/// Of the emitted model, along its own motion.
struct Run {
  double angle = k_breaks_down;  ///< rad, at the end
  double change = 0;             ///< W: largest rate of the energy
  double balance = 0;            ///< W: the same less the power of the bar's reaction
  double seconds = 0;
};

/// dE/dt = q' m q'' + m g z', and what the bar adds to the equation of x times the speed of the pivot: across the bar there is no force.
template <class Model>
void balance(const Model& model, const Parameters& p, double t, const State& state, Run& run) {
  gauss::shaken_bob::Derivative<double> rate;
  gauss::shaken_bob::Reactions<double> reactions_here;
  if (model.derivative(t, state, rate) != gauss::Status::ok ||
      reactions(t, state, gauss::shaken_bob::Inputs<double>{}, model.prepared(), reactions_here) != gauss::Status::ok)
    return grow(run.balance, k_breaks_down);
  const double* v = state.values + 2;
  const double* a = rate.values + 2;
  const double change = p.m * (v[0] * a[0] + v[1] * (a[1] + p.g));
  grow(run.change, change);
  grow(run.balance, change - reactions_here.bar.generalized[0] * pivot(p, t).speed);
}

template <class Model>
Run simulate(const Model& model, const Parameters& p, const State& start) {
  Run result;
  const Stopwatch stopwatch;
  gauss::simulate::FixedStep<Model, gauss::integrate::Projected<gauss::integrate::Prince8<Model>>> run(model, start,
                                                                                                       k_step);
  const bool arrives = run.advance(k_steps, [&](double t, const State& state) { balance(model, p, t, state, result); });
  if (arrives) result.angle = std::atan2(run.state().values[0] - pivot(p, run.time()).place, -run.state().values[1]);
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace

std::vector<Figure> shaken_bar() {
  const Parameters p;
  const auto prepared = ShakenBob::prepare(p);
  const auto model = gauss::integrate::bind_model<ShakenBob>(prepared, gauss::shaken_bob::Inputs<double>{});
  State start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {{"H20.bar", "angle after 2 s", "rad"}};
  const double exact = angle_by_minimal_model(p, start);
  const Run ours = simulate(model, p, start);
  const auto angle = [&](const char* id, const char* naive, const Shares& shares) -> Figure {
    return {id,
            std::string("angle after 2 s of a bar on a shaking pivot, in x and z, naive ") + naive,
            "rad",
            size(angle_by_hand(p, start, shares) - exact),
            size(ours.angle - exact),
            1e-10,
            0,
            ours.seconds};
  };
  Figure mixed = angle("H20.mixed", "with half of the mixed term 2 q' f_qt", {0.5, 1});
  char text[64];
  std::snprintf(text, sizeof text, "the same form with all terms: %.1g",
                std::abs(angle_by_hand(p, start, {1, 1}) - exact));
  mixed.remark = text;
  // Of a bar at rest, whose reaction has no power, nothing would change the energy: all of the change is missed.
  return {mixed,
          angle("H20.by_time", "without f_tt", {1, 0}),
          {"H20.bar_power", "rate of its energy less the power of the bar, naive without this power", "1", 1,
           ours.balance / ours.change, 1e-10, 0, ours.seconds}};
}

}  // namespace hard_cases
