#include "run.hpp"

#include <algorithm>
#include <chrono>

#include "gauss/simulate/simulation.hpp"

namespace sphere {

namespace {

// The models, with the results that the demo asks for.
struct Euler : EulerModel {
  using Residuals = euler::Residuals<double>;
  using ReactionForces = euler::ReactionForces<double>;
};

struct UnitQuaternion : QuaternionModel {
  using Residuals = quaternion::Residuals<double>;
  using ReactionForces = quaternion::ReactionForces<double>;
};

// A model without quaternions has no residual of position.
template <class Residuals>
auto quaternion_drift(int, const Residuals& residuals) -> decltype(std::abs(residuals.quaternion[0])) {
  return std::abs(residuals.quaternion[0]);
}
template <class Residuals>
double quaternion_drift(long, const Residuals&) {
  return 0;
}

template <class Model>
class Laboratory {
 public:
  using State = typename Model::template State<double>;
  using Derivative = typename Model::template Derivative<double>;

  Run simulate(const Plan& plan) {
    State start;
    initial_state(prepared_, start);
    const auto model = gauss::integrate::bind_model<Model>(prepared_, inputs_);
    gauss::simulate::Settings<double> settings;
    settings.tolerance = plan.tolerance;
    gauss::simulate::Simulation simulation(model, start, 0.0, settings);

    sample(0, start);
    const int samples = static_cast<int>(std::lround(plan.duration / plan.sampling));
    for (int k = 1; k <= samples; ++k) {
      const double t = plan.duration * k / samples;
      const bool arrived = simulation.advance_to(t, [this](double now, const State& before, const State& after) {
        grow(run_.before_projection, now, before);
        grow(run_.after_projection, now, after);
        run_.lowest_height = std::min(run_.lowest_height, after.zeta());
      });
      if (!arrived) {
        run_.trouble = std::string(name(simulation.report().outcome)) + ", " + name(simulation.report().status);
        break;
      }
      sample(t, simulation.state());
    }
    run_.steps = simulation.report().steps;
    run_.rejected = simulation.report().rejected;
    run_.calls = simulation.report().calls;
    run_.nanoseconds = time_rhs();
    run_.operations = count_operations();
    return run_;
  }

 private:
  void sample(double t, const State& state) {
    typename Model::ReactionForces forces;
    run_.samples.push_back(observe(t, state, inputs_, prepared_, forces));
    const gauss::Status status = run_.samples.back().status;
    if (status != gauss::Status::ok) run_.trouble = std::string("reactions: ") + name(status);
    states_.push_back(state);
  }

  void grow(Drift& drift, double t, const State& state) const {
    typename Model::Residuals found;
    residuals(t, state, inputs_, prepared_, Derivative{}, found);
    drift.quaternion = worse(drift.quaternion, quaternion_drift(0, found));
    for (const double phi : found.velocity) drift.velocity = worse(drift.velocity, std::abs(phi));
  }

  // Over the states of the run, so that no compiler can compute the answer in advance. The first batch warms up.
  double time_rhs() const {
    using Clock = std::chrono::steady_clock;
    constexpr int k_batches = 101;
    constexpr int k_rounds = 20;
    std::vector<double> batches;
    double checksum = 0;
    for (int batch = 0; batch <= k_batches; ++batch) {
      const Clock::time_point begin = Clock::now();
      for (int round = 0; round < k_rounds; ++round) {
        for (const State& state : states_) {
          Derivative derivative;
          rhs(0.0, state, inputs_, prepared_, derivative);
          for (const double value : derivative.values) checksum += value;
        }
      }
      const std::chrono::duration<double, std::nano> taken = Clock::now() - begin;
      if (batch > 0) batches.push_back(taken.count() / static_cast<double>(k_rounds * states_.size()));
    }
    // Keeps the results alive.
    volatile double sink = checksum;
    static_cast<void>(sink);
    std::nth_element(batches.begin(), batches.begin() + k_batches / 2, batches.end());
    return batches[k_batches / 2];
  }

  Operations count_operations() const {
    const auto prepared = prepare(typename Model::template Parameters<Counted>{});
    typename Model::template State<Counted> state;
    for (std::size_t i = 0; i < std::size(state.values); ++i) state.values[i] = Counted(states_.back().values[i]);
    typename Model::template Derivative<Counted> derivative;
    Counted::tally() = {};
    rhs(Counted(0), state, typename Model::template Inputs<Counted>{}, prepared, derivative);
    return Counted::tally();
  }

  typename Model::template Inputs<double> inputs_{};
  typename Model::template Prepared<double> prepared_ = prepare(typename Model::template Parameters<double>{});
  Run run_;
  std::vector<State> states_;
};

}  // namespace

Run run_euler(const Plan& plan) { return Laboratory<Euler>().simulate(plan); }
Run run_quaternion(const Plan& plan) { return Laboratory<UnitQuaternion>().simulate(plan); }

Quaternion<long double> attitude_at_start() {
  const euler::Parameters<long double> parameters;
  return from_euler(parameters.psi_0, parameters.theta_0, parameters.phi_0);
}

Data data_of_models() {
  const euler::Parameters<double> parameters;
  euler::State<double> start;
  initial_state(prepare(parameters), start);
  return {parameters.m,    parameters.r,     parameters.R,        parameters.g,
          start.chi_dot(), start.zeta_dot(), parameters.omega_r_0};
}

}  // namespace sphere
