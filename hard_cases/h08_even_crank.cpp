// A slider-crank with a rod as long as its crank, over its change point: there the slider could also stay in the main bearing, and crank and rod turn
// as one. Steps follow the error; where a step ends is a matter of chance, so a hundred speeds are tried.

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <string>

#include "even_crank.hpp"
#include "gauss/model_concept.hpp"
#include "gauss/simulate/simulation.hpp"
#include "registry.hpp"

namespace hard_cases {

namespace crank = gauss::even_crank;
GAUSS_MODEL(EvenCrank, gauss::even_crank);

namespace {

constexpr double k_turn = 6.283185307179586, k_duration = 10, k_radius = 0.3, k_start = 0.2;
constexpr int k_runs = 100;

crank::State<double> start_of(int run) {
  const double rate = 3 + 0.03 * run;
  return {{k_start, -2 * k_start, 2 * k_radius * std::cos(k_start), rate, -2 * rate,
           -2 * k_radius * std::sin(k_start) * rate}};
}

bool is_on_branch(double theta, double phi) { return std::abs(std::remainder(phi + 2 * theta, k_turn)) < 1e-3; }

struct Runs {
  double lost = 0;      ///< that stop, or go on along the other branch
  double switched = 0;  ///< of these, without a word
  double seconds = 0;
};

/// The same pair of Prince and Dormand's order, by Odeint alone: no projection, its own measure of errors.
Runs by_odeint(const crank::Prepared<double>& prepared, double tolerance) {
  using Array = std::array<double, 6>;
  namespace odeint = boost::numeric::odeint;
  Stopwatch stopwatch;
  Runs runs;
  for (int k = 0; k < k_runs; ++k) {
    const auto start = start_of(k);
    Array x{};
    std::copy(start.values, start.values + 6, x.begin());
    long calls = 0;
    const auto system = [&](const Array& at, Array& rates, double t) {
      crank::State<double> state{};
      crank::Derivative<double> derivative{};
      std::copy(at.begin(), at.end(), state.values);
      if (++calls > 100'000) throw odeint::step_adjustment_error("too many steps");
      rhs(t, state, {}, prepared, derivative);
      std::copy(derivative.values, derivative.values + 6, rates.begin());
    };
    bool stays = true;
    try {
      odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_fehlberg78<Array>>(tolerance, tolerance),
                                 system, x, 0.0, k_duration, 1e-3,
                                 [&](const Array& at, double) { stays = stays && is_on_branch(at[0], at[1]); });
    } catch (const odeint::step_adjustment_error&) {
      stays = false;
    }
    runs.lost += stays ? 0 : 1;
  }
  runs.seconds = stopwatch.seconds();
  return runs;
}

Runs by_simulation(const crank::Prepared<double>& prepared, double tolerance, long& crossings) {
  const crank::Inputs<double> none{};
  const auto model = gauss::integrate::bind_model<EvenCrank>(prepared, none);
  Stopwatch stopwatch;
  Runs runs;
  for (int k = 0; k < k_runs; ++k) {
    gauss::simulate::Settings<double> settings;
    settings.tolerance = tolerance;
    gauss::simulate::Simulation simulation(model, start_of(k), 0.0, settings);
    bool stays = true;
    const bool arrives = simulation.advance_to(k_duration, [&](double, const auto&, const auto& state) {
      stays = stays && is_on_branch(state.theta(), state.phi());
    });
    runs.lost += stays && arrives ? 0 : 1;
    runs.switched += stays || !arrives ? 0 : 1;
    crossings += simulation.report().crossings;
  }
  runs.seconds = stopwatch.seconds();
  return runs;
}

}  // namespace

std::vector<Figure> even_crank() {
  const auto prepared = prepare(crank::Parameters<double>{});
  std::vector<Figure> figures;
  for (const auto& [name, tolerance] : {std::pair{"1e-8", 1e-8}, {"1e-10", 1e-10}, {"1e-12", 1e-12}}) {
    long crossings = 0;
    const Runs naive = by_odeint(prepared, tolerance), ours = by_simulation(prepared, tolerance, crossings);
    const std::string id = std::string("H08.crank.") + name;
    figures.push_back({id, "runs of 100 over the change point of a slider-crank that stop or change the branch", "1",
                       naive.lost, ours.lost, 3, naive.seconds, ours.seconds,
                       "naive: Odeint's fehlberg78; ours: Simulation, " + std::to_string(crossings) + " crossings"});
    figures.push_back(
        {id + ".silent", "of these, on the other branch without a word", "1", std::nullopt, ours.switched, 0});
  }
  return figures;
}

}  // namespace hard_cases
