// Units in which numbers are 1e9 times as large or as small. What is told by a tolerance is told by the model's own sizes: results and statuses
// stay as they are. Units change by powers of two (2^30 is 1.07e9), so that nothing is rounded otherwise.

#include <cmath>
#include <random>
#include <string>

#include "absolute_pivots.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "gauss/simulate/simulation.hpp"
#include "heavy_chain.hpp"
#include "near_parallel.hpp"
#include "parallelogram.hpp"
#include "pendulum_cartesian.hpp"
#include "registry.hpp"
#include "units.hpp"
#include "weightless_angle.hpp"

namespace hard_cases {

GAUSS_MODEL(ParallelForUnits, gauss::near_parallel);
GAUSS_MODEL(AngleForUnits, gauss::weightless_angle);
GAUSS_MODEL(ChainForUnits, gauss::heavy_chain);
GAUSS_MODEL(LoopForUnits, gauss::parallelogram);
GAUSS_MODEL(BobForUnits, gauss::pendulum_cartesian);

namespace {

/// The equations of the model, g a = f + b^T lambda and b a + drift = 0, are filled into a `System`: the emitted struct, or one by hand.
template <class M, class System>
struct Model {
  using State = typename M::template State<double>;
  using Derivative = typename M::template Derivative<double>;
  static constexpr int n = M::n_q + M::n_v;

  typename M::template Parameters<double> parameters;
  const gauss::Quantity* table;  ///< of parameters

  typename M::template Parameters<double> in(const Units& units) const {
    auto result = parameters;
    const auto& members = M::template parameters_of<double>();
    for (int i = 0; i < M::n_parameters; ++i) result.*members[i] *= factor(table[i].unit, units);
    return result;
  }

  /// Coordinates, then speeds; `rates`: per unit of time.
  static void convert(double (&values)[n], const Units& units, bool are_rates, bool is_back) {
    for (int i = 0; i < n; ++i) {
      const char* unit = i < M::n_q ? M::coordinates[i].unit : M::speeds[i - M::n_q].unit;
      const double by = factor(unit, units) * (are_rates ? std::ldexp(1.0, -units.time) : 1.0);
      values[i] = is_back ? values[i] / by : values[i] * by;
    }
  }

  struct Results {
    Derivative rates{};
    State projected{};
    gauss::Status of_rates, of_projection;
  };

  Results results(State state, const Units& units) const {
    const auto prepared = M::prepare(in(units));
    convert(state.values, units, false, false);
    Results found;
    found.projected = state;
    found.of_rates = M::rhs(0.0, state, {}, prepared, found.rates);
    found.of_projection = project(0.0, state, prepared, found.projected);
    convert(found.rates.values, units, true, true);
    convert(found.projected.values, units, false, true);
    return found;
  }

  System equations(State state, const Units& units) const {
    System system{};
    convert(state.values, units, false, false);
    (void)linear_system(0.0, state, typename M::template Inputs<double>{}, M::prepare(in(units)), system);
    return system;
  }

  /// Accelerations of the naive form, back in m, kg and s, behind n_q zeros.
  Derivative naive(const State& state, const Units& units) const {
    double accelerations[M::n_v];
    accelerations_by_absolute_pivots(equations(state, units), accelerations);
    Derivative result{};
    for (int i = 0; i < M::n_v; ++i) result.values[M::n_q + i] = accelerations[i];
    convert(result.values, units, true, true);
    return result;
  }

  void compare(const State& state, Change& change) const {
    const Results base = results(state, {});
    const Derivative naive_base = naive(state, {});
    for (const Units& units : k_units) {
      change.compare_naive(naive_base.values, naive(state, units).values, n);
      const Results now = results(state, units);
      change.compare(base.of_rates, now.of_rates);
      change.compare(base.of_projection, now.of_projection);
      change.compare(base.rates.values, now.rates.values, n);
      change.compare(base.projected.values, now.projected.values, n);
    }
  }

  /// Where a thousand projected steps lead from a state in m, kg and s.
  State end_of_motion(State state, const Units& units) const {
    const auto prepared = M::prepare(in(units));
    const auto bound = gauss::integrate::bind_model<M>(prepared, typename M::template Inputs<double>{});
    using Bound = std::decay_t<decltype(bound)>;
    convert(state.values, units, false, false);
    gauss::simulate::FixedStep<Bound, gauss::integrate::Projected<gauss::integrate::Rk4<Bound>>> run(
        bound, state, std::ldexp(1.0, units.time - 10));
    const bool arrives = run.advance(1000, [&](double, const auto& now) { state = now; });
    if (!arrives) state.values[0] = std::nan("");
    convert(state.values, units, false, true);
    return state;
  }

  /// Where a simulation with an estimate of its error leads in two units of time, from a state in m, kg and s; `smallest` is an absolute scale.
  State end_of_simulation(State state, const Units& units, double smallest) const {
    const auto bound = gauss::integrate::bind_model<M>(M::prepare(in(units)), typename M::template Inputs<double>{});
    convert(state.values, units, false, false);
    gauss::simulate::Settings<double> settings;
    settings.smallest_scale = smallest;
    settings.most_steps = 10'000;
    gauss::simulate::Simulation<std::decay_t<decltype(bound)>> run(bound, state, 0.0, settings);
    State end = run.advance_to(std::ldexp(2.0, units.time)) ? run.state() : State{};
    convert(end.values, units, false, true);
    return end;
  }

  void compare_simulation(const State& start, Change& change) const {
    const State base = end_of_simulation(start, {}, 0), naive_base = end_of_simulation(start, {}, 1);
    for (const Units& units : k_units) {
      change.compare(base.values, end_of_simulation(start, units, 0).values, n);
      change.compare_naive(naive_base.values, end_of_simulation(start, units, 1).values, n);
    }
  }

  void compare_motion(const State& start, Change& change) const {
    const State base = end_of_motion(start, {});
    for (const Units& units : k_units) {
      const State now = end_of_motion(start, units);
      change.compare(base.values, now.values, n);
    }
  }
};

template <class M>
typename M::template State<double> random_state(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  typename M::template State<double> state{};
  for (double& value : state.values) value = uniform(engine);
  return state;
}

template <class M, class System>
Change at_random_states(const Model<M, System>& model) {
  std::mt19937_64 engine(31);
  Change change;
  for (int i = 0; i < 20; ++i) model.compare(random_state<M>(engine), change);
  return change;
}

/// By hand: an emitted header of a model whose constraints cannot follow from each other has none.
struct AngleSystem {
  double g[3][3], f[3], b[2][3], drift[2];
};
gauss::Status linear_system(double, const gauss::weightless_angle::State<double>& state,
                            const gauss::weightless_angle::Inputs<double>&,
                            const gauss::weightless_angle::Prepared<double>& prepared, AngleSystem& system) {
  const double c = prepared.l * std::cos(state.theta()), s = prepared.l * std::sin(state.theta());
  const double square = state.theta_dot() * state.theta_dot();
  system = {{{prepared.m, 0, 0}, {0, prepared.m, 0}, {0, 0, 0}},
            {0, -prepared.m * prepared.g, 0},
            {{1, 0, -c}, {0, 1, -s}},
            {s * square, -c * square}};
  return gauss::Status::ok;
}

using ParallelModel = Model<ParallelForUnits, gauss::near_parallel::LinearSystem<double>>;
using AngleModel = Model<AngleForUnits, AngleSystem>;
using ChainModel = Model<ChainForUnits, gauss::heavy_chain::LinearSystem<double>>;
using LoopModel = Model<LoopForUnits, gauss::parallelogram::LinearSystem<double>>;
using BobModel = Model<BobForUnits, gauss::pendulum_cartesian::LinearSystem<double>>;

/// Rows that make an angle, down to none: first and third differ in one coefficient.
Change nearly_parallel() {
  Change change;
  for (int digits = 1; digits <= 17; ++digits) {
    ParallelModel model{{}, gauss::near_parallel::parameter_table};
    const auto& members = ParallelForUnits::parameters_of<double>();
    for (int i = 0; i < 6; ++i) model.parameters.*members[24 + i] = model.parameters.*members[12 + i];
    model.parameters.*members[24] *= 1 + std::pow(10.0, -digits);
    std::mt19937_64 engine(5);
    model.compare(random_state<ParallelForUnits>(engine), change);
  }
  return change;
}

Change heavy_ends() {
  Change change;
  for (const double ratio : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    ChainModel model{{}, gauss::heavy_chain::parameter_table};
    model.parameters.ratio = ratio;
    const Change now = at_random_states(model);
    grow(change.largest, now.largest);
    grow(change.naive, now.naive);
    change.statuses += now.statuses;
  }
  return change;
}

/// `naive`: ranks by absolute pivots that differ.
Change flat_loop(double& naive) {
  const LoopModel model{{}, gauss::parallelogram::parameter_table};
  Change change = at_random_states(model);
  for (const double off : {0.0, 1e-16, 1e-12, 1e-9, 1e-6, 1e-3}) {
    const gauss::parallelogram::State<double> state{{off, -off, off, 6, -6, 6}};
    model.compare(state, change);
    for (const Units& units : k_units) {
      if (rank_by_absolute_pivots(model.equations(state, units)) != rank_by_absolute_pivots(model.equations(state, {})))
        ++naive;
    }
  }
  gauss::parallelogram::State<double> start;
  change.compare(gauss::Status::ok, initial_state(LoopForUnits::prepare(model.parameters), start));
  model.compare_motion(start, change);
  return change;
}

Change bob() {
  const BobModel model{{}, gauss::pendulum_cartesian::parameter_table};
  Change change = at_random_states(model);
  gauss::pendulum_cartesian::State<double> start;
  change.compare(gauss::Status::ok, initial_state(BobForUnits::prepare(model.parameters), start));
  model.compare_motion(start, change);
  return change;
}

/// Steps that follow the error, from rest.
Change simulated() {
  const BobModel model{{}, gauss::pendulum_cartesian::parameter_table};
  Change change;
  model.compare_simulation({{0.6, -0.8, 0, 0}}, change);
  return change;
}

}  // namespace

std::vector<Figure> units(const Scope&) {
  double naive = 0;
  const std::pair<const char*, Change> changes[] = {
      {"H05", nearly_parallel()},
      {"H06", at_random_states(AngleModel{{}, gauss::weightless_angle::parameter_table})},
      {"H07", heavy_ends()},
      {"H08", flat_loop(naive)},
      {"H13", bob()}};
  std::vector<Figure> figures;
  double statuses = 0;
  for (const auto& [id, change] : changes) {
    figures.push_back(
        {std::string("H31.") + id,
         "change of results in 10 other systems of units, relative; naive: of accelerations by elimination, "
         "pivots up to 1e-9 taken for zero",
         "1", change.naive, change.largest, 1e-12});
    statuses += change.statuses;
  }
  const Change simulation = simulated();
  figures.push_back({"H31.simulation",
                     "change of where a simulation with an estimate of its error ends, relative; naive: errors beside "
                     "no less than 1 in the unit of each component, 0 if it does not "
                     "arrive in 10000 steps",
                     "1", simulation.naive, simulation.largest, 1e-12});
  figures.push_back({"H31.statuses", "statuses that differ there", "1", naive, statuses, 0, 0, 0,
                     "naive: ranks of H08 by pivots above 1e-9"});
  return figures;
}

}  // namespace hard_cases
