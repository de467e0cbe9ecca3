// The methods of SUNDIALS: tolerances, orders, whose Jacobian it is, constraints, and what is reported.
#include <cmath>
#include <stdexcept>

#include "ball_on_plane_euler.hpp"
#include "bound.hpp"
#include "catch_shim.hpp"
#include "double_pendulum.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/euler_charts.hpp"
#include "gauss/integrate/sdirk.hpp"
#include "gauss/model_concept.hpp"
#include "gauss/simulate/cvode.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "gauss/simulate/simulation.hpp"
#include "pendulum_cartesian.hpp"
#include "stiff_relaxation.hpp"
#include "stiff_spring.hpp"

GAUSS_MODEL(SteadyDouble, gauss::double_pendulum);
GAUSS_MODEL(SteadyBob, gauss::pendulum_cartesian);
GAUSS_MODEL(Relaxation, gauss::stiff_relaxation);
GAUSS_MODEL(Spring, gauss::stiff_spring);
GAUSS_MODEL(Roller, gauss::ball_on_plane_euler);

namespace {

using gauss::Status;
using namespace gauss::integrate;
using gauss::simulate::CvodeSimulation;
using gauss::simulate::FixedStep;
using gauss::simulate::Multistep;
using gauss::simulate::Outcome;
using gauss::simulate::Settings;
using physics::distance;
using physics::start_of;

auto double_pendulum() { return bind_model<SteadyDouble>(); }
auto bob() { return bind_model<SteadyBob>(); }
auto relaxation() { return bind_model<Relaxation>(); }
using DoubleModel = decltype(double_pendulum());
using BobModel = decltype(bob());
using RelaxationModel = decltype(relaxation());
using DoubleState = gauss::double_pendulum::State<double>;
using DoubleJacobian =
    EmittedJacobian<gauss::double_pendulum::Jacobian<double>, gauss::double_pendulum::JacobianByState>;
using BobJacobian =
    EmittedJacobian<gauss::pendulum_cartesian::Jacobian<double>, gauss::pendulum_cartesian::JacobianByState>;
using RelaxationJacobian =
    EmittedJacobian<gauss::stiff_relaxation::Jacobian<double>, gauss::stiff_relaxation::JacobianByState>;

const DoubleState k_start{{1.1, -0.7, 0.5, 0.2}};

Settings<double> tolerance(double value) {
  Settings<double> settings;
  settings.tolerance = value;
  return settings;
}

DoubleState exact_after_one_second() {
  gauss::simulate::Simulation<DoubleModel> simulation(double_pendulum(), k_start);
  REQUIRE(simulation.advance_to(1));
  return simulation.state();
}

double error_of(Multistep method, double tolerated) {
  CvodeSimulation<DoubleModel, DoubleJacobian> simulation(double_pendulum(), k_start, 0, tolerance(tolerated), method);
  REQUIRE(simulation.advance_to(1));
  CHECK(simulation.time() == 1);
  CHECK(simulation.report().steps > 0);
  return distance(simulation.state(), exact_after_one_second());
}

template <class State>
double off_the_bar(const State& state) {
  const double* y = state.values;
  return std::max(std::abs(std::hypot(y[0], y[1]) - 1), std::abs(y[0] * y[2] + y[1] * y[3]));
}

/// The bob with a model that fails left of 0.25 m.
struct WallModel : BobModel {
  WallModel() : BobModel(bob()) {}
  Status derivative(double t, const State& state, Derivative& result) const {
    const Status status = BobModel::derivative(t, state, result);
    return state.values[0] < 0.25 ? Status::singular_mass_matrix : status;
  }
};

/// A mass of 1 kg that rests at 0 until a force acts on it, by hand.
struct PushedCart {
  struct State {
    double values[2];
  };
  using Derivative = State;
  using Scalar = double;
  using Status = gauss::Status;
  static constexpr std::size_t size = 2, n_q = 1;
  double at, force;
  Status derivative(double t, const State& state, Derivative& result) const {
    result = {{state.values[1], t > at ? force : 0}};
    return Status::ok;
  }
  Status projection(double, State&) const { return Status::ok; }
  const char* unit(std::size_t i) const { return i == 0 ? "m" : "m/s"; }
};

}  // namespace

TEST_CASE("the errors of multistep methods follow the tolerance") {
  for (const Multistep method : {Multistep::bdf, Multistep::adams}) {
    CHECK(error_of(method, 1e-6) < 1e-3);
    CHECK(error_of(method, 1e-6) > 1e-8);
    CHECK(error_of(method, 1e-10) < 1e-7);
    CHECK(error_of(method, 1e-10) < error_of(method, 1e-8));
  }
}

TEST_CASE("requested times are reached exactly, in as many pieces as are asked for") {
  CvodeSimulation<DoubleModel, DoubleJacobian> simulation(double_pendulum(), k_start, 0, tolerance(1e-10));
  for (const double t : {0.1, 0.3, 0.3000001, 0.7, 1.0}) {
    REQUIRE(simulation.advance_to(t));
    CHECK(simulation.time() == t);
  }
  CHECK(distance(simulation.state(), exact_after_one_second()) < 1e-7);
}

TEST_CASE("with the emitted Jacobian no rates are evaluated for differences") {
  CvodeSimulation<DoubleModel, DoubleJacobian> emitted(double_pendulum(), k_start, 0, tolerance(1e-8));
  CvodeSimulation<DoubleModel> differences(double_pendulum(), k_start, 0, tolerance(1e-8));
  REQUIRE(emitted.advance_to(10));
  REQUIRE(differences.advance_to(10));
  CHECK(emitted.report().jacobians > 0);
  CHECK(differences.report().jacobians == 0);
  // Four for each of about as many Jacobians.
  CHECK(differences.report().calls - emitted.report().calls > 2 * emitted.report().jacobians);
  CHECK(distance(emitted.state(), differences.state()) < 1e-3);
}

TEST_CASE("BDF projects each state; without, the constraint is lost as far as the tolerance allows") {
  Settings<double> settings = tolerance(1e-6);
  CvodeSimulation<BobModel, BobJacobian> projected(bob(), start_of(bob()), 0, settings);
  double worst = 0;
  REQUIRE(projected.advance_to(20, [&](double, const auto& state) { worst = std::max(worst, off_the_bar(state)); }));
  CHECK(worst < 1e-13);
  settings.project = false;
  CvodeSimulation<BobModel, BobJacobian> free(bob(), start_of(bob()), 0, settings);
  REQUIRE(free.advance_to(20));
  CHECK(off_the_bar(free.state()) > 1e-7);
}

TEST_CASE(
    "a start outside of the model is refused at once; a motion that runs out of it ends there, with the model's "
    "status") {
  const WallModel model;
  CvodeSimulation<WallModel> running(model, start_of(bob()), 0, tolerance(1e-8));
  CHECK_FALSE(running.advance_to(5));
  CHECK(running.report().outcome == Outcome::step_too_small);
  CHECK(running.report().status == Status::singular_mass_matrix);
  CHECK(running.time() > 0.1);
  CHECK(running.state().values[0] == Approx(0.25).margin(1e-3));
  CHECK_FALSE(running.advance_to(6));

  auto beyond = start_of(bob());
  beyond.values[0] = -0.6;
  CvodeSimulation<WallModel> never(model, beyond, 0, tolerance(1e-8));
  CHECK_FALSE(never.advance_to(5));
  CHECK(never.report().outcome == Outcome::model_failed);
  CHECK(never.report().status == Status::singular_mass_matrix);
  CHECK(never.report().steps == 0);
  CHECK(never.time() == 0);
}

TEST_CASE("what a controller throws arrives where the simulation was called") {
  const auto inputs = [](double t, const gauss::double_pendulum::State<double>&) {
    if (t > 0.5) throw std::runtime_error("no signal");
    return gauss::double_pendulum::Inputs<double>{};
  };
  const auto model = bind_model<SteadyDouble>(double_pendulum().prepared(), inputs);
  CvodeSimulation<std::decay_t<decltype(model)>> simulation(model, k_start, 0, tolerance(1e-8));
  CHECK_THROWS_AS(simulation.advance_to(1), std::runtime_error);
}

TEST_CASE("CVODE, too, refuses settings out of their range, and says by how much it moved the start") {
  Settings<double> settings = tolerance(-1e-8);
  CvodeSimulation<BobModel, BobJacobian> refused(bob(), start_of(bob()), 0, settings);
  CHECK_FALSE(refused.advance_to(1));
  CHECK(refused.report().outcome == Outcome::bad_settings);
  CHECK(refused.time() == 0);
  CvodeSimulation<BobModel, BobJacobian> never(bob(), start_of(bob()), std::nan(""), tolerance(1e-8));
  CHECK_FALSE(never.advance_to(1));
  CHECK(never.report().outcome == Outcome::bad_settings);

  auto beside = start_of(bob());
  for (int i = 0; i < 2; ++i) beside.values[i] *= 1.01;
  CvodeSimulation<BobModel, BobJacobian> moved(bob(), beside, 0, tolerance(1e-8));
  CHECK(off_the_bar(moved.state()) < 1e-13);
  const std::size_t most = moved.report().start_component;
  CHECK(moved.report().start_moved > 0.001);
  CHECK(moved.report().start_moved == std::abs(moved.state().values[most] - beside.values[most]));
}

TEST_CASE("the limit of steps is one") {
  Settings<double> settings = tolerance(1e-10);
  settings.most_steps = 5;
  CvodeSimulation<DoubleModel, DoubleJacobian> simulation(double_pendulum(), k_start, 0, settings);
  CHECK_FALSE(simulation.advance_to(1));
  CHECK(simulation.report().outcome == Outcome::too_many_steps);
  CHECK(simulation.report().steps == 5);
}

TEST_CASE("SDIRK steps have order 4, forwards and back") {
  using Stepper = Sdirk<DoubleModel, DoubleJacobian>;
  const DoubleState exact = exact_after_one_second();
  const auto error = [&](int steps) {
    FixedStep<DoubleModel, Stepper> run(double_pendulum(), k_start, 1.0 / steps);
    REQUIRE(run.advance(steps));
    CHECK(run.stepper().jacobians() > 0);
    return distance(run.state(), exact);
  };
  CHECK(std::log2(error(200) / error(400)) == Approx(4).margin(0.3));
  FixedStep<DoubleModel, Stepper> run(double_pendulum(), k_start, 0.001);
  REQUIRE(run.advance(500));
  run.turn_back();
  REQUIRE(run.advance(500));
  CHECK(distance(run.state(), k_start) < 1e-9);
}

TEST_CASE("SDIRK takes the state that it is given, and forgets its own") {
  const DoubleModel model = double_pendulum();
  Sdirk<DoubleModel, DoubleJacobian> used, fresh;
  DoubleState elsewhere{{0.3, 0.2, -1, 1}}, after = k_start, wanted = k_start;
  REQUIRE(used.step(model, 7, 0.02, elsewhere).is_taken());
  REQUIRE(used.step(model, 0, 0.01, after).is_taken());
  REQUIRE(fresh.step(model, 0, 0.01, wanted).is_taken());
  CHECK(distance(after, wanted) < 1e-12);
}

TEST_CASE("SDIRK is a stepper like others: it is projected, and it works without an emitted Jacobian") {
  FixedStep<BobModel, Projected<Sdirk<BobModel>>> run(bob(), start_of(bob()), 0.01);
  REQUIRE(run.advance(1000));
  CHECK(off_the_bar(run.state()) < 1e-13);
  CHECK(run.stepper().inner().jacobians() == 0);
}

TEST_CASE("a rate of 1e6/s is gone after one step of a millisecond") {
  gauss::stiff_relaxation::State<double> start{{0, 3}};
  FixedStep<RelaxationModel, Sdirk<RelaxationModel, RelaxationJacobian>> run(relaxation(), start, 1e-3);
  REQUIRE(run.advance(1));
  CHECK(run.state().values[1] == Approx(std::cos(1e-3)).epsilon(0).margin(0.05));
  REQUIRE(run.advance(9));
  CHECK(run.state().values[1] == Approx(std::cos(1e-2)).epsilon(0).margin(1e-8));
}

TEST_CASE("SDIRK leads to the same place in other units, where numbers are 2^40 times as small, too") {
  using Stepper = Sdirk<BobModel, BobJacobian>;
  const auto end = [](int length, int time) {
    gauss::pendulum_cartesian::Parameters<double> p;
    p.L = std::ldexp(1.0, length);
    p.g = std::ldexp(9.81, length - 2 * time);
    FixedStep<BobModel, Stepper> run(bind_model<SteadyBob>(p), {{0.6 * p.L, -0.8 * p.L, 0, 0}}, std::ldexp(0.01, time));
    REQUIRE(run.advance(100));
    auto state = run.state();
    for (int i = 0; i < 4; ++i) state.values[i] = std::ldexp(state.values[i], i < 2 ? -length : time - length);
    return state;
  };
  for (const int length : {-40, 40})
    for (const int time : {-40, 40}) CHECK(distance(end(length, time), end(0, 0)) < 1e-12);
}

TEST_CASE("a step over the edge of the model is refused, and the state stays") {
  const WallModel model;
  FixedStep<WallModel, Sdirk<WallModel>> run(model, start_of(bob()), 0.01);
  CHECK_FALSE(run.advance(1000));
  CHECK(run.last().outcome == StepOutcome::model_failed);
  CHECK(run.last().status == Status::singular_mass_matrix);
  CHECK(run.state().values[0] >= 0.25);
}

TEST_CASE(
    "energy and constraints are kept over SUNDIALS: by a decorator of SDIRK, and by the projection of BDF and of steps "
    "with an estimate") {
  using Energy = gauss::pendulum_cartesian::Energy<double>;
  const auto miss = [](const auto& state) {
    Energy first, now;
    REQUIRE(bob().energy(0, start_of(bob()), first) == Status::ok);
    REQUIRE(bob().energy(0, state, now) == Status::ok);
    CHECK(off_the_bar(state) < 1e-13);
    return std::abs(now.total / first.total - 1);
  };
  FixedStep<BobModel, EnergyKept<Projected<Sdirk<BobModel, BobJacobian>>, Energy>> sdirk(bob(), start_of(bob()), 0.01);
  REQUIRE(sdirk.advance(1000));
  CHECK(miss(sdirk.state()) < 1e-13);
  CHECK(sdirk.stepper().correction().applied > 500);

  using Kept = WithEnergyKept<BobModel, Energy>;
  const Kept kept(bob(), 0, start_of(bob()));
  CvodeSimulation<BobModel, BobJacobian> plain_bdf(bob(), start_of(bob()), 0, tolerance(1e-7));
  CvodeSimulation<Kept, BobJacobian> bdf(kept, start_of(bob()), 0, tolerance(1e-7));
  REQUIRE(plain_bdf.advance_to(10));
  REQUIRE(bdf.advance_to(10));
  CHECK(miss(plain_bdf.state()) > 1e-6);
  CHECK(miss(bdf.state()) < 1e-13);

  gauss::simulate::Simulation<BobModel> plain(bob(), start_of(bob()), 0, tolerance(1e-6));
  gauss::simulate::Simulation<Kept> steps(kept, start_of(bob()), 0, tolerance(1e-6));
  REQUIRE(plain.advance_to(10));
  REQUIRE(steps.advance_to(10));
  CHECK(miss(plain.state()) > 1e-8);
  CHECK(miss(steps.state()) < 1e-13);
}

TEST_CASE("a scale of speeds of their own is what errors of speeds are measured by") {
  const auto steps = [](double smallest_speed) {
    Settings<double> settings = tolerance(1e-8);
    settings.smallest_scale = 10;
    settings.smallest_speed = smallest_speed;
    CvodeSimulation<DoubleModel, DoubleJacobian> bdf(double_pendulum(), k_start, 0, settings);
    gauss::simulate::Simulation<DoubleModel> explicit_steps(double_pendulum(), k_start, 0, settings);
    REQUIRE(bdf.advance_to(10));
    REQUIRE(explicit_steps.advance_to(10));
    return std::pair(bdf.report().steps, explicit_steps.report().steps);
  };
  const auto usual = steps(0), same = steps(10), finer = steps(1e-3);
  CHECK(usual == same);
  CHECK(finer.first > usual.first);
  CHECK(finer.second > usual.second);
}

TEST_CASE(
    "multistep methods, too, have no unit of their own: other units lead to the same place, and a small swing is "
    "followed") {
  for (const Multistep method : {Multistep::bdf, Multistep::adams}) {
    const auto swing = [&](int length, int time) {
      gauss::pendulum_cartesian::Parameters<double> p;
      p.L = std::ldexp(1.0, length);
      p.g = std::ldexp(9.81, length - 2 * time);
      CvodeSimulation<BobModel, BobJacobian> run(bind_model<SteadyBob>(p), {{0.6 * p.L, -0.8 * p.L, 0, 0}}, 0,
                                                 tolerance(1e-9), method);
      REQUIRE(run.advance_to(std::ldexp(2.0, time)));
      auto state = run.state();
      for (int i = 0; i < 4; ++i) state.values[i] = std::ldexp(state.values[i], i < 2 ? -length : time - length);
      return state;
    };
    // Pivots of Newton's matrix may be others, so roundings are.
    for (const int length : {-40, 40})
      for (const int time : {-40, 40}) CHECK(distance(swing(length, time), swing(0, 0)) < 1e-6);

    gauss::pendulum_cartesian::Parameters<double> small;
    small.L = 1e-3;
    const double amplitude = 1e-12, rate = std::sqrt(small.g / small.L);
    CvodeSimulation<BobModel, BobJacobian> run(bind_model<SteadyBob>(small), {{amplitude, -small.L, 0, 0}}, 0,
                                               tolerance(1e-8), method);
    REQUIRE(run.advance_to(0.1));
    CHECK(run.state().values[0] / amplitude == Approx(std::cos(rate * 0.1)).epsilon(0).margin(1e-3));
  }
}

TEST_CASE("multistep methods begin to move with a force, and take what hangs at rest for what it is") {
  for (const Multistep method : {Multistep::bdf, Multistep::adams}) {
    CvodeSimulation<BobModel, BobJacobian> hanging(bob(), {{0.6e-16, -1, 0, 0}}, 0, tolerance(1e-9), method);
    REQUIRE(hanging.advance_to(100));
    CHECK(hanging.report().steps < 10000);
    for (const double at : {0.0, 1e-6, 0.5}) {
      for (const double size : {1e-20, 1.0, 1e20}) {
        const PushedCart cart{at, size};
        CvodeSimulation<PushedCart> run(cart, {{0, 0}}, 0, tolerance(1e-9), method);
        const bool arrives = run.advance_to(2);
        INFO(at << ' ' << size << ": " << name(run.report().outcome) << " at " << run.time() << ", "
                << run.report().steps << " steps");
        REQUIRE(arrives);
        const double span = 2 - at;
        CHECK(run.state().values[0] / size == Approx(span * span / 2).epsilon(1e-6));
        CHECK(run.state().values[1] / size == Approx(span).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("BDF comes off order 1 where errors of places are a hundred times as large in speeds as these may be off") {
  const auto spring = bind_model<Spring>();
  using Jacobian = EmittedJacobian<gauss::stiff_spring::Jacobian<double>, gauss::stiff_spring::JacobianByState>;
  Settings<double> settings = tolerance(1e-8);
  settings.smallest_speed = 10;
  settings.most_steps = 5000;
  CvodeSimulation<std::decay_t<decltype(spring)>, Jacobian> run(spring, {{1 / (1 + 1e-6), 1e-3 / (1 + 1e-6)}}, 0,
                                                                settings);
  CHECK(run.advance_to(10));
  CHECK(run.state().values[0] == Approx(std::cos(10 - 1e-3)).margin(1e-6));
}

TEST_CASE("BDF needs no scale of speeds where a place makes speeds that are up to a million times as large") {
  using Jacobian = EmittedJacobian<gauss::stiff_spring::Jacobian<double>, gauss::stiff_spring::JacobianByState>;
  // k/c, from 100/s to 1e6/s.
  for (const double damping : {1e7, 1e6, 1e5, 1e4, 1e3}) {
    for (const double allowed : {1e-6, 1e-8, 1e-9, 1e-10}) {
      gauss::stiff_spring::Parameters<double> parameters;
      parameters.c = damping;
      const double lag = damping / parameters.k;  // s: of m s'' + c s' + k s = k cos t, where m s'' is nothing beside
      Settings<double> settings = tolerance(allowed);
      settings.most_steps = 5000;
      const auto spring = bind_model<Spring>(parameters);
      CvodeSimulation<std::decay_t<decltype(spring)>, Jacobian> run(
          spring, {{1 / (1 + lag * lag), lag / (1 + lag * lag)}}, 0, settings);
      INFO(damping << ' ' << allowed << ": " << run.report().steps);
      CHECK(run.advance_to(10));
      const double place = (std::cos(10.0) + lag * std::sin(10.0)) / (1 + lag * lag);
      CHECK(run.state().values[0] == Approx(place).epsilon(0).margin(10 * allowed + 1e-11));
      const double speed = (-std::sin(10.0) + lag * std::cos(10.0)) / (1 + lag * lag);
      CHECK(run.state().values[1] == Approx(speed).epsilon(0).margin(3000 * allowed));
    }
  }
}

TEST_CASE("multistep methods go through the pole of Euler angles in two charts, and begin anew there") {
  namespace emitted = gauss::ball_on_plane_euler;
  const auto roller = bind_model<Roller>();
  using Charted =
      gauss::integrate::InEulerCharts<std::decay_t<decltype(roller)>, gauss::integrate::EulerSequence<'z', 'x', 'z'>>;
  using Jacobian = EmittedJacobian<emitted::Jacobian<double>, emitted::JacobianByState>;
  // Upright, which is the pole; rolling keeps the angular velocity, so that the axis is upright again after each turn.
  const gauss::integrate::Vector3<double> omega{1, 0.3, 0.4};
  const double size = std::sqrt(1.25);
  for (const auto method : {Multistep::bdf, Multistep::adams}) {
    Charted charted(roller, {{2, 3, 4}, {7, 8, 9}});
    emitted::State<double> start{};
    charted.place({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, omega, start);
    start.x_dot() = 0.1 * omega[1];
    start.y_dot() = -0.1 * omega[0];
    CvodeSimulation<Charted, Jacobian> run(charted, start, 0, tolerance(1e-11), method);
    REQUIRE(run.advance_to(20));
    const double half = 10 * size, s = std::sin(half) / size;
    const auto exact =
        gauss::integrate::rotation_of<double>({std::cos(half), s * omega[0], s * omega[1], s * omega[2]});
    const auto found = run.model().attitude(run.state());
    const auto turns = run.model().angular_velocity(run.state());
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(turns[i] == Approx(omega[i]).epsilon(0).margin(1e-8));
      for (std::size_t j = 0; j < 3; ++j) CHECK(found[i][j] == Approx(exact[i][j]).epsilon(0).margin(1e-8));
    }
    CHECK(run.state().y() == Approx(-2).epsilon(0).margin(1e-8));
    INFO(run.model().switches() << " switches, " << run.report().steps << " steps");
    CHECK(run.model().switches() >= 6);
    // All of them count, and not those since it began anew alone.
    CHECK(run.report().steps > 100 * run.model().switches());
    CHECK(run.report().calls > run.report().steps);
  }
}
