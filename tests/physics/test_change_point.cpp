// The change point of a linkage: a slider-crank with a rod as long as its crank. On the branch phi = -2 theta it has one motion, of which the energy
// gives the speed:
//   T = theta_dot²/2 (J + rod r² (1/3 + 2 sin²theta) + 4 m r² sin²theta), since the middle of the rod is at r (3/2 cos theta, -1/2 sin theta), it turns by
// -theta, and the slider is at 2 r cos theta.
#include <cmath>

#include "bound.hpp"
#include "catch_shim.hpp"
#include "even_crank.hpp"
#include "gauss/model_concept.hpp"
#include "gauss/simulate/simulation.hpp"

namespace crank = gauss::even_crank;
GAUSS_MODEL(Crank, gauss::even_crank);

namespace {

using gauss::Status;
using gauss::simulate::Outcome;

const crank::Parameters<double>& parameters() {
  static const crank::Parameters<double> p;
  return p;
}

const crank::Prepared<double>& prepared() {
  static const crank::Prepared<double> p = prepare(parameters());
  return p;
}

double inertia(double theta) {
  const auto& p = parameters();
  const double s2 = std::sin(theta) * std::sin(theta);
  return p.J + p.rod * p.r * p.r * (1.0 / 3 + 2 * s2) + 4 * p.m * p.r * p.r * s2;
}

/// dI/dtheta / 2 theta_dot² + I theta_ddot = 0
double acceleration(double theta, double rate) {
  const auto& p = parameters();
  const double slope = std::sin(2 * theta) * (2 * p.rod + 4 * p.m) * p.r * p.r;
  return -slope * rate * rate / (2 * inertia(theta));
}

crank::State<double> on_branch(double theta, double rate) {
  crank::State<double> state{};
  state.theta() = theta;
  state.phi() = -2 * theta;
  state.s() = 2 * parameters().r * std::cos(theta);
  state.theta_dot() = rate;
  state.phi_dot() = -2 * rate;
  state.s_dot() = -2 * parameters().r * std::sin(theta) * rate;
  return state;
}

const double k_quarter = std::acos(0.0);

struct Runs {
  int on_branch = 0, switched = 0, stopped = 0;
  long crossings = 0;
  double worst = 0;  ///< of the energy of those that stay
};

/// 10 s at a hundred speeds, looked at every 0.1 s.
Runs runs(double tolerance) {
  static const crank::Inputs<double> none{};
  const auto model = gauss::integrate::bind_model<Crank>(prepared(), none);
  gauss::simulate::Settings<double> settings;
  settings.tolerance = tolerance;
  settings.most_steps = 20'000;
  Runs result;
  for (int k = 0; k < 100; ++k) {
    const auto start = on_branch(0.2, 3 + 0.03 * k);
    gauss::simulate::Simulation simulation(model, start, 0.0, settings);
    double farthest = 0;
    bool is_running = true;
    for (int i = 1; i <= 100 && is_running; ++i) {
      is_running = simulation.advance_to(0.1 * i);
      const auto state = simulation.state();
      farthest = std::fmax(farthest, std::abs(std::remainder(state.phi() + 2 * state.theta(), 4 * k_quarter)));
    }
    result.crossings += simulation.report().crossings;
    if (!is_running) {
      ++result.stopped;
    } else if (farthest > 1e-3) {
      ++result.switched;
    } else {
      ++result.on_branch;
      const auto state = simulation.state();
      const double before = inertia(0.2) * start.theta_dot() * start.theta_dot();
      const double after = inertia(state.theta()) * state.theta_dot() * state.theta_dot();
      result.worst = std::fmax(result.worst, std::abs(after / before - 1));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("a linkage runs over its change point, at every tolerance, and stays on its branch") {
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const Runs of = runs(tolerance);
    INFO(tolerance << ": " << of.on_branch << " stay, " << of.switched << " switch, " << of.stopped << " stop, "
                   << of.crossings << " crossings, energy to " << of.worst);
    CHECK(of.switched == 0);
    CHECK(of.on_branch >= 97);  // others stop, and say so
    CHECK(of.worst < 1e3 * std::sqrt(tolerance));
  }
}

TEST_CASE("near a change point, all functions see one rank, and nothing that is not finite or huge is ok") {
  int dependent = 0;
  for (const double d : {1e-1, 1e-2, 1e-3, 1e-5, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-15, 0.0}) {
    for (const double off : {0.0, 1e-15, -1e-15}) {
      INFO("at " << d << " rad, " << off << " off");
      auto state = on_branch(k_quarter - d, 5);
      state.theta() += off;
      crank::Derivative<double> derivative;
      crank::Reactions<double> reactions;
      crank::Mobility<double> mobility;
      const crank::Inputs<double> none{};
      const Status status = rhs_and_reactions(0.0, state, none, prepared(), derivative, reactions);
      CHECK(crank::mobility(0.0, state, none, prepared(), mobility) == Status::ok);
      CHECK((status == Status::ok) == (mobility.rank == 2));
      dependent += status == Status::dependent_constraints ? 1 : 0;
      // By what rounding of the state makes of it.
      const double exact = acceleration(state.theta(), 5);
      CHECK(std::abs(derivative.theta_ddot() - exact) < 1e-9 + 100 * 2e-15 * 25 / std::fmax(d * d, 1e-15));
    }
  }
  CHECK(dependent > 9);
}

TEST_CASE("a state beside a change point that satisfies the constraints is left where it is, with its speeds") {
  for (double d = 1e-9; d < 1; d *= 1.7) {
    const auto state = on_branch(k_quarter - d, 5);
    crank::State<double> projected;
    INFO(d << " rad beside it");
    const Status status = project(0.0, state, prepared(), projected);
    CHECK((status == Status::ok || status == Status::dependent_constraints));
    for (int i = 0; i < 6; ++i) CHECK(std::abs(projected.values[i] - state.values[i]) < 1e-6);
  }
}
