// Steps that adapt themselves: delivered errors, the motion between steps, projection, and what is reported.

#include "gauss/simulate/taylor_simulation.hpp"

#include <cmath>
#include <memory>

#include "catch_shim.hpp"
#include "gauss/integrate/bound_model.hpp"
#include "kepler.hpp"
#include "pendulum_cartesian.hpp"

namespace {

GAUSS_MODEL(Orbit, gauss::kepler);
GAUSS_MODEL(Rod, gauss::pendulum_cartesian);

using gauss::simulate::Outcome;
using gauss::simulate::Settings;

template <class Model>
auto bound(const typename Model::template Parameters<double>& parameters = {}) {
  return gauss::integrate::bind_model<Model>(parameters);
}

using BoundOrbit = decltype(bound<Orbit>());
using OrbitSimulation = gauss::simulate::TaylorSimulation<BoundOrbit, gauss::kepler::TaylorSeries<double>>;
using BoundRod = decltype(bound<Rod>());
using RodSimulation = gauss::simulate::TaylorSimulation<BoundRod, gauss::pendulum_cartesian::TaylorSeries<double>>;

gauss::kepler::State<double> at_pericentre(const BoundOrbit& model) {
  gauss::kepler::State<double> state;
  initial_state(model.prepared(), state);
  return state;
}

/// x and y at time t, by Kepler's equation.
void place_on_ellipse(double t, double e, double& x, double& y) {
  double E = t;
  for (int i = 0; i < 100; ++i) E -= (E - e * std::sin(E) - t) / (1 - e * std::cos(E));
  x = std::cos(E) - e;
  y = std::sqrt(1 - e * e) * std::sin(E);
}

double error_after(double end, double tolerance) {
  const BoundOrbit model = bound<Orbit>();
  Settings<double> settings;
  settings.tolerance = tolerance;
  const auto simulation = std::make_unique<OrbitSimulation>(model, at_pericentre(model), 0.0, settings);
  REQUIRE(simulation->advance_to(end));
  double x = 0, y = 0;
  place_on_ellipse(end, 0.9, x, y);
  return std::hypot(simulation->state().x() - x, simulation->state().y() - y);
}

}  // namespace

TEST_CASE("an orbit of eccentricity 0.9 follows its tolerance") {
  CHECK(error_after(8, 1e-6) < 1e-3);
  CHECK(error_after(8, 1e-9) < 1e-6);
  CHECK(error_after(8, 1e-13) < 1e-10);
  CHECK(error_after(8, 1e-13) < error_after(8, 1e-6));
}

TEST_CASE("a time within a step costs no step") {
  const BoundOrbit model = bound<Orbit>();
  const auto often = std::make_unique<OrbitSimulation>(model, at_pericentre(model));
  const auto once = std::make_unique<OrbitSimulation>(model, at_pericentre(model));
  double worst = 0;
  for (int i = 1; i <= 1000; ++i) {
    REQUIRE(often->advance_to(0.005 * i));
    CHECK(often->time() == 0.005 * i);
    double x = 0, y = 0;
    place_on_ellipse(0.005 * i, 0.9, x, y);
    worst = std::max(worst, std::hypot(often->state().x() - x, often->state().y() - y));
  }
  REQUIRE(once->advance_to(5.0));
  CHECK(often->report().steps <= once->report().steps + 1);
  CHECK(worst < 1e-9);
}

TEST_CASE("units do not matter: a thousandth of the length takes the same steps") {
  gauss::kepler::Parameters<double> small;
  small.a = 1e-3;
  small.mu = 1e-9;
  const BoundOrbit a = bound<Orbit>(), b = bound<Orbit>(small);
  const auto large = std::make_unique<OrbitSimulation>(a, at_pericentre(a));
  const auto tiny = std::make_unique<OrbitSimulation>(b, at_pericentre(b));
  REQUIRE(large->advance_to(20.0));
  REQUIRE(tiny->advance_to(20.0));
  CHECK(std::abs(large->report().steps - tiny->report().steps) <= 1);
}

TEST_CASE("every state that is shown satisfies the constraints") {
  const BoundRod model = bound<Rod>();
  gauss::pendulum_cartesian::State<double> start;
  initial_state(model.prepared(), start);
  const auto simulation = std::make_unique<RodSimulation>(model, start);
  const double length = std::hypot(start.values[0], start.values[1]);
  for (int i = 1; i <= 100; ++i) {
    REQUIRE(simulation->advance_to(0.1 * i));
    const auto& state = simulation->state();
    CHECK(std::abs(std::hypot(state.values[0], state.values[1]) - length) < 1e-14);
  }
}

TEST_CASE("a collision ends with a report, not with numbers") {
  const BoundOrbit model = bound<Orbit>();
  const gauss::kepler::State<double> falling{{1, 0, 0, 0}};
  Settings<double> settings;
  settings.project = false;
  const auto simulation = std::make_unique<OrbitSimulation>(model, falling, 0.0, settings);
  // It falls for pi/sqrt(8) = 1.11.
  CHECK(simulation->advance_to(1.0));
  CHECK_FALSE(simulation->advance_to(1.2));
  CHECK((simulation->report().outcome == Outcome::step_too_small ||
         simulation->report().outcome == Outcome::model_failed));
  CHECK(simulation->time() == 1.0);
}

TEST_CASE("a start without a series says so") {
  const BoundOrbit model = bound<Orbit>();
  const gauss::kepler::State<double> centre{{0, 0, 1, 0}};
  const auto simulation = std::make_unique<OrbitSimulation>(model, centre);
  CHECK_FALSE(simulation->advance_to(1.0));
  CHECK(simulation->report().outcome == Outcome::model_failed);
  CHECK(simulation->report().status == gauss::Status::not_finite);
}

TEST_CASE("settings out of range integrate nothing") {
  const BoundOrbit model = bound<Orbit>();
  for (const double tolerance : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    Settings<double> settings;
    settings.tolerance = tolerance;
    const auto simulation = std::make_unique<OrbitSimulation>(model, at_pericentre(model), 0.0, settings);
    CHECK_FALSE(simulation->advance_to(1.0));
    CHECK(simulation->report().outcome == Outcome::bad_settings);
  }
}

namespace {

/// A ball that falls upwards beyond x = 1, which its series does not see: the motion of two parabolas.
struct Kinked {
  using Scalar = double;
  struct State {
    double values[2];
  };
  using Status = gauss::Status;
  static constexpr std::size_t size = 2, n_q = 1, n_v = 1;
  struct Series {
    static constexpr int most = 40;
    int order = 0;
    double values[most + 1][2] = {};
  };

  Status series(double, const State& state, int order, Series& result) const {
    result = Series{};
    result.order = order;
    const double a = state.values[0] < 1 ? 0 : -10;
    result.values[0][0] = state.values[0];
    result.values[0][1] = result.values[1][0] = state.values[1];
    result.values[1][1] = a;
    result.values[2][0] = a / 2;
    return Status::ok;
  }
  Status projection(double, State&) const { return Status::ok; }
  const char* unit(std::size_t component) const { return component == 0 ? "m" : "m/s"; }
};

}  // namespace

TEST_CASE("a step over an edge that its series does not see is refused until it is brief") {
  gauss::simulate::TaylorSimulation<Kinked, Kinked::Series> simulation(Kinked{}, {{0.0, 1.0}});
  REQUIRE(simulation.advance_to(1.05));
  // At the edge at t = 1, and 0.05 s against 10 m/s^2.
  CHECK(std::abs(simulation.state().values[0] - (1 + 0.05 - 5 * 0.05 * 0.05)) < 1e-8);
  CHECK(simulation.report().rejected > 0);
}
