// A rod on a pivot that shakes by a law in time, against an equation for its angle that was derived by hand.

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "pendulum_moving_pivot.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(Rod, gauss::pendulum_moving_pivot);

namespace {

using Parameters = gauss::pendulum_moving_pivot::Parameters<double>;

constexpr double k_step = 1e-4;
constexpr std::int64_t k_steps = 20'000;

/// Of the pivot's height, stroke cos(Omega t).
double pivot_acceleration(const Parameters& p, double t) {
  return -p.stroke * p.Omega * p.Omega * std::cos(p.Omega * t);
}

/// theta'' = 3/(2 l) (g + h'') sin theta: moments about the pivot, in axes that move with it. `share` of h'' is kept.
double angle_by_hand(const Parameters& p, double share) {
  using Pair = std::array<double, 2>;
  boost::numeric::odeint::runge_kutta_fehlberg78<Pair> method;
  Pair x = {0.15, 0};
  const auto system = [&](const Pair& at, Pair& rate, double t) {
    rate[0] = at[1];
    rate[1] = 3 / (2 * p.l) * (p.g + share * pivot_acceleration(p, t)) * std::sin(at[0]);
  };
  for (std::int64_t k = 0; k < k_steps; ++k) method.do_step(system, x, static_cast<double>(k) * k_step, k_step);
  return x[0];
}

/// The reaction along the height times its rate, W.
template <class Model>
double power(const Model& model, const Parameters& p, double t, const typename Model::State& state) {
  gauss::pendulum_moving_pivot::Reactions<double> reactions_here;
  if (reactions(t, state, gauss::pendulum_moving_pivot::Inputs<double>{}, model.prepared(), reactions_here) !=
      gauss::Status::ok)
    return k_breaks_down;
  return reactions_here.height.generalized * -p.stroke * p.Omega * std::sin(p.Omega * t);
}

struct Run {
  double angle = k_breaks_down;    ///< rad, at the end
  double balance = k_breaks_down;  ///< J: energy gained, less the work of the reaction by Simpson's rule
  double gain = 0;                 ///< J
  double energy = 0;               ///< J: largest
};

template <class Model>
Run simulate(const Model& model, const Parameters& p, const typename Model::State& start) {
  Run result;
  gauss::pendulum_moving_pivot::Energy<double> energy;
  if (model.energy(0.0, start, energy) != gauss::Status::ok) return result;
  const double first = energy.total;
  double work = power(model, p, 0.0, start);
  gauss::simulate::FixedStep<Model, gauss::integrate::Prince8<Model>> run(model, start, k_step);
  const bool arrives = run.advance(k_steps, [&](double t, const auto& state) {
    const double weight = run.steps() == k_steps ? 1 : run.steps() % 2 == 0 ? 2 : 4;
    work += weight * power(model, p, t, state);
    model.energy(t, state, energy);
    result.energy = std::max(result.energy, std::abs(energy.total));
  });
  if (!arrives) return result;
  result.angle = run.state().values[0];
  result.gain = energy.total - first;
  result.balance = result.gain - work * k_step / 3;
  return result;
}

}  // namespace

std::vector<Figure> moving_pivot(const Scope&) {
  Parameters p;
  p.stroke = 0.1;
  p.Omega = 30;
  const auto prepared = Rod::prepare(p);
  const auto model = gauss::integrate::bind_model<Rod>(prepared, gauss::pendulum_moving_pivot::Inputs<double>{});
  gauss::pendulum_moving_pivot::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {{"H20.angle", "angle after 2 s", "rad"}};
  Stopwatch stopwatch;
  const Run ours = simulate(model, p, start);
  const double seconds = stopwatch.seconds();
  const double exact = angle_by_hand(p, 1);
  std::vector<Figure> figures = {
      {"H20.angle",
       "angle after 2 s, naive without the pivot's acceleration",
       "rad",
       std::abs(angle_by_hand(p, 0) - exact),
       std::abs(ours.angle - exact),
       1e-10,
       0,
       seconds,
       "",
       {}},
      {"H20.power",
       "energy gained less the work of the reaction, by the largest energy, naive without this work",
       "1",
       std::abs(ours.gain) / ours.energy,
       std::abs(ours.balance) / ours.energy,
       1e-10,
       0,
       seconds,
       "",
       {}}};
  for (const Figure& figure : shaken_bar()) figures.push_back(figure);
  return figures;
}

}  // namespace hard_cases
