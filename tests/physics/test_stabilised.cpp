// Baumgarte's gains: violations decay as the linear law says, motions on the constraints do not feel them, and no gain does what projection does.
#include <array>
#include <cmath>

#include "bicycle.hpp"
#include "bound.hpp"
#include "catch_shim.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/stabilised.hpp"
#include "gauss/model_concept.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "gauss/simulate/simulation.hpp"
#include "pendulum_cartesian.hpp"
#include "skew_nonholonomic.hpp"

GAUSS_MODEL(PulledBob, gauss::pendulum_cartesian);
GAUSS_MODEL(PulledBicycle, gauss::bicycle);
GAUSS_MODEL(PulledBlade, gauss::skew_nonholonomic);

namespace {

using namespace gauss::integrate;
using gauss::Status;
using gauss::simulate::FixedStep;
using physics::distance;
using physics::start_of;

auto bob() { return bind_model<PulledBob>(); }
auto blade() { return bind_model<PulledBlade>(); }
auto bicycle() { return bind_model<PulledBicycle>(); }
using Bob = decltype(bob());
using Blade = decltype(blade());
using Bicycle = decltype(bicycle());
using PulledBobModel =
    Stabilised<Bob, gauss::pendulum_cartesian::Residuals<double>, gauss::pendulum_cartesian::LinearSystem<double>>;
/// By residuals of candidate accelerations, as headers without a linear system have it.
using PulledBobByMass =
    Stabilised<Bob, gauss::pendulum_cartesian::Residuals<double>, gauss::pendulum_cartesian::MassMatrix<double>>;
using PulledBladeModel =
    Stabilised<Blade, gauss::skew_nonholonomic::Residuals<double>, gauss::skew_nonholonomic::MassMatrix<double>>;
using PulledBicycleModel = Stabilised<Bicycle, gauss::bicycle::Residuals<double>, gauss::bicycle::LinearSystem<double>>;

template <class Model, class Residuals>
Residuals violation(const Model& model, double t, const typename Model::State& state) {
  Residuals result;
  REQUIRE(residuals(t, state, model.inputs(t, state), model.prepared(), typename Model::Derivative{}, result) ==
          Status::ok);
  return result;
}

/// Of x'' + 2 alpha x' + beta^2 x = 0 from (x, v).
struct Decay {
  double alpha, beta, x, v;
  double operator()(double t) const {
    const double rest = beta * beta - alpha * alpha, w = std::sqrt(std::abs(rest));
    const double across = v + alpha * x;
    if (rest == 0) return std::exp(-alpha * t) * (x + across * t);
    if (rest > 0) return std::exp(-alpha * t) * (x * std::cos(w * t) + across / w * std::sin(w * t));
    return std::exp(-alpha * t) * (x * std::cosh(w * t) + across / w * std::sinh(w * t));
  }
};

/// Largest error of the law beside the largest violation, over 2 s.
template <class Model>
double error_of_decay(const Model& model, const Decay& law, typename Model::State state) {
  FixedStep<Model, Rk4<Model>> run(model, state, 1e-3);
  double largest = 0;
  REQUIRE(run.advance(2000, [&](double t, const auto& at) {
    const auto now = violation<Bob, gauss::pendulum_cartesian::Residuals<double>>(model.base(), t, at);
    const double miss = std::abs(now.position[0] - law(t)) / std::abs(law.x);
    if (!(miss <= largest)) largest = miss;
  }));
  return largest;
}

struct Drift {
  double position = 0, speed = 0;
};

template <class Stepper, class Model>
Drift drift(const Model& model, int seconds) {
  FixedStep<Model, Stepper> run(model, start_of(bob()), 1e-3);
  Drift largest;
  REQUIRE(run.advance(1000 * seconds, [&](double, const auto& state) {
    const double* y = state.values;
    largest.position = std::max(largest.position, std::abs(std::hypot(y[0], y[1]) - 1));
    largest.speed = std::max(largest.speed, std::abs(y[0] * y[2] + y[1] * y[3]));
  }));
  return largest;
}

}  // namespace

TEST_CASE("a violated equation of positions decays as the gains say: critically, as an oscillation, aperiodically") {
  const auto make = [](double alpha, double beta) { return PulledBobModel(bob(), {alpha, beta}, 1); };
  auto state = start_of(bob());
  state.values[0] *= 1 + 1e-3;
  state.values[1] *= 1 + 1e-3;
  const auto start = violation<Bob, gauss::pendulum_cartesian::Residuals<double>>(bob(), 0, state);
  CHECK(start.position[0] == Approx(1e-3).epsilon(1e-3));
  for (const auto& [alpha, beta] : {std::pair{5.0, 5.0}, {3.0, 5.0}, {5.0, 3.0}, {0.0, 2.0}})
    CHECK(error_of_decay(make(alpha, beta), {alpha, beta, start.position[0], start.velocity[0]}, state) < 1e-8);
  // The form of the documents, from rest.
  const Decay critical{5, 5, 1, 0};
  CHECK(critical(0.3) == Approx(std::exp(-1.5) * 2.5).epsilon(1e-14));
}

TEST_CASE(
    "a violated constraint of velocities decays as exp(-2 alpha t), by the mass matrix where there is no linear "
    "system") {
  const PulledBladeModel model(blade(), {2, 7}, 1);
  auto state = start_of(blade());
  state.values[Blade::n_q + 2] += 0.1;
  const double start = violation<Blade, gauss::skew_nonholonomic::Residuals<double>>(blade(), 0, state).velocity[0];
  CHECK(std::abs(start) > 0.1);
  FixedStep<PulledBladeModel, Rk4<PulledBladeModel>> run(model, state, 1e-3);
  double largest = 0;
  REQUIRE(run.advance(1000, [&](double t, const auto& at) {
    const auto now = violation<Blade, gauss::skew_nonholonomic::Residuals<double>>(blade(), t, at);
    largest = std::max(largest, std::abs(now.velocity[0] / start - std::exp(-4 * t)));
  }));
  CHECK(largest < 1e-9);
}

TEST_CASE("rows of both kinds: each asks for what the gains and its own violations say") {
  const std::array<int, 2> heights{0, 3};
  const PulledBicycleModel model(bicycle(), {3, 4}, 6, heights);
  auto state = start_of(bicycle());
  for (std::size_t i = 0; i < Bicycle::size; ++i)
    state.values[i] += 1e-3 * std::sin(1.0 + 2.0 * static_cast<double>(i));
  Bicycle::Derivative found;
  REQUIRE(model.derivative(0, state, found) == Status::ok);
  gauss::bicycle::Residuals<double> at;
  REQUIRE(residuals(0.0, state, {}, bicycle().prepared(), found, at) == Status::ok);
  double largest = 0;
  for (int mu = 0; mu < 6; ++mu) {
    double wanted = -6 * at.velocity[mu];
    for (std::size_t i = 0; i < heights.size(); ++i)
      if (heights[i] == mu) wanted -= 16 * at.position[i];
    CHECK(std::abs(wanted) > 1e-4);
    largest = std::max(largest, std::abs(at.acceleration[mu] - wanted));
  }
  CHECK(largest < 1e-11);
}

TEST_CASE("accelerations differ from those of the model along the gradients alone, and not at all on the constraints") {
  const PulledBobModel model(bob(), {5, 5}, 1);
  const PulledBobByMass by_mass(bob(), {5, 5}, 1);
  Bob::Derivative plain, pulled, also;
  FixedStep<Bob, Projected<Rk4<Bob>>> run(bob(), start_of(bob()), 1e-2);
  for (int k = 0; k < 100; ++k) {
    REQUIRE(run.advance(1));
    Bob::State state = run.state();
    REQUIRE(bob().derivative(0, state, plain) == Status::ok);
    REQUIRE(model.derivative(0, state, pulled) == Status::ok);
    CHECK(distance(plain, pulled) < 1e-13);
    state.values[0] += 0.01;
    REQUIRE(bob().derivative(0, state, plain) == Status::ok);
    REQUIRE(model.derivative(0, state, pulled) == Status::ok);
    REQUIRE(by_mass.derivative(0, state, also) == Status::ok);
    CHECK(distance(pulled, also) < 1e-13);
    // The bob's metric is the mass: what is added points along the bar.
    const double ax = pulled.values[2] - plain.values[2], ay = pulled.values[3] - plain.values[3];
    CHECK(std::abs(ax * state.values[1] - ay * state.values[0]) < 1e-13);
  }
}

TEST_CASE("drift of the bar in 100 s: gains bound it, projection leaves rounding") {
  const Drift naive = drift<Rk4<Bob>>(bob(), 100);
  const Drift pulled = drift<Rk4<PulledBobModel>>(PulledBobModel(bob(), {5, 5}, 1), 100);
  const Drift projected = drift<Projected<Rk4<Bob>>>(bob(), 100);
  INFO(naive.position << ' ' << pulled.position << ' ' << projected.position);
  CHECK(naive.position > 1e-8);
  CHECK(pulled.position < 1e-11);
  CHECK(pulled.position > 1e-13);
  CHECK(pulled.speed < 1e-10);
  CHECK(projected.position < 1e-15);
}

TEST_CASE("a stabilised model is one for simulations with an estimate of their error, too") {
  const auto steps = [](double gain) {
    gauss::simulate::Settings<double> settings;
    settings.project = false;
    settings.tolerance = 1e-9;
    gauss::simulate::Simulation<PulledBobModel> run(PulledBobModel(bob(), {gain, gain}, 1), start_of(bob()), 0,
                                                    settings);
    REQUIRE(run.advance_to(20));
    const auto state = run.state();
    CHECK(std::abs(std::hypot(state.values[0], state.values[1]) - 1) < 1e-7);
    return run.report().steps;
  };
  CHECK(steps(100) > 2 * steps(5));
}
