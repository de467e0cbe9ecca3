// What constraints keep from turning does not turn, but by rounding; no step may be judged by that.

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "catch_shim.hpp"
#include "gauss/simulate/simulation.hpp"
#include "hung_straight.hpp"
#include "hung_straight_twice.hpp"
#include "skater_quaternion.hpp"
#include "straight_cart.hpp"
#include "straight_sledge.hpp"
#include "tied_flywheels.hpp"
#include "tilted_carriage.hpp"

GAUSS_MODEL(Carriage, gauss::tilted_carriage);
GAUSS_MODEL(Cart, gauss::straight_cart);
GAUSS_MODEL(Flywheels, gauss::tied_flywheels);
GAUSS_MODEL(Hung, gauss::hung_straight);
GAUSS_MODEL(HungTwice, gauss::hung_straight_twice);
GAUSS_MODEL(Skater, gauss::skater_quaternion);
GAUSS_MODEL(Sledge, gauss::straight_sledge);

namespace {

using gauss::Status;

struct Reached {
  double x, y, turn;
  long steps;
};

template <class Model>
Reached after(double t, double tolerance, const typename Model::template Parameters<double>& parameters = {}) {
  const auto prepared = prepare(parameters);
  typename Model::template State<double> start;
  REQUIRE(initial_state(prepared, start) == Status::ok);
  gauss::simulate::Settings<double> settings;
  settings.tolerance = tolerance;
  settings.most_steps = 2000;
  const typename Model::template Inputs<double> inputs{};
  gauss::simulate::Simulation run(gauss::integrate::bind_model<Model>(prepared, inputs), start, 0.0, settings);
  INFO("tolerance " << tolerance << ", stopped at " << run.time());
  CHECK(run.advance_to(t));
  CHECK(run.report().with_fewer_constraints == 0);
  const auto state = run.state();
  return {state.x(), state.y(), state.th() - start.th(), run.report().steps};
}

/// v t + F t^2/(2 m) along the heading.
template <class Model>
void check_straight() {
  for (const double heading : {0.0, 0.1, 0.3, 0.5, 1.0, 2.0}) {
    typename Model::template Parameters<double> parameters;
    parameters.a = heading;
    const double way = parameters.v * 10 + parameters.F * 100 / (2 * parameters.m);
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
      const Reached found = after<Model>(10, tolerance, parameters);
      CHECK(found.x == Approx(way * std::cos(heading)).epsilon(1e-12));
      CHECK(found.y == Approx(way * std::sin(heading)).epsilon(1e-12).margin(1e-12));
      CHECK(std::abs(found.turn) < 1e-13);
    }
  }
}

/// As a pendulum: all of it goes along a circle of radius c.
double swung(double from, double v, double c, double g, double t) {
  double angle = from, rate = v / c;
  const int steps = 200'000;
  const double h = t / steps;
  for (int i = 0; i < steps; ++i) {
    rate -= h / 2 * g / c * std::sin(angle);
    angle += h * rate;
    rate -= h / 2 * g / c * std::sin(angle);
  }
  return angle;
}

template <class Model>
void check_swing() {
  for (const double from : {0.3, 0.6, 0.9}) {
    typename Model::template Parameters<double> parameters;
    parameters.start = from;
    const double angle = swung(from, 0, parameters.c, parameters.g, 5);
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
      const Reached found = after<Model>(5, tolerance, parameters);
      CHECK(found.x == Approx(parameters.c * std::sin(angle)).margin(1e-4 * std::sqrt(tolerance * 1e6) + 1e-7));
      CHECK(std::abs(found.turn) < 1e-13);
    }
  }
}

}  // namespace

TEST_CASE("a sledge and a cart go straight") {
  check_straight<Sledge>();
  check_straight<Cart>();
}

TEST_CASE("a slab on parallel bars swings without turning") {
  check_swing<Hung>();
  check_swing<HungTwice>();
}

// On three bars it has no change point: it goes over the top, again and again. From below, all starts at 0 but its speed.
TEST_CASE("a slab on three parallel bars goes round") {
  gauss::hung_straight_twice::Parameters<double> parameters;
  parameters.start = 0;
  parameters.v = 8;
  const double angle = swung(0, parameters.v, parameters.c, parameters.g, 5);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const Reached found = after<HungTwice>(5, tolerance, parameters);
    CHECK(found.x == Approx(parameters.c * std::sin(angle)).margin(1e-4 * std::sqrt(tolerance * 1e6) + 1e-7));
    CHECK(std::abs(found.turn) < 1e-13);
  }
}

// What is tied together is not held: A cos 100 t.
TEST_CASE("a small vibration of flywheels that are tied to each other is followed") {
  const gauss::tied_flywheels::Parameters<double> parameters;
  const auto prepared = prepare(parameters);
  const gauss::tied_flywheels::Inputs<double> inputs{};
  gauss::tied_flywheels::State<double> start;
  REQUIRE(initial_state(prepared, start) == Status::ok);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    gauss::simulate::Settings<double> settings;
    settings.tolerance = tolerance;
    gauss::simulate::Simulation run(gauss::integrate::bind_model<Flywheels>(prepared, inputs), start, 0.0, settings);
    REQUIRE(run.advance_to(10));
    const double part = std::max(1e3 * tolerance, 1e-7);
    CHECK(run.state().c() == Approx(parameters.A * std::cos(1000.0)).margin(part * parameters.A));
    CHECK(run.state().c_dot() == Approx(-100 * parameters.A * std::sin(1000.0)).margin(100 * part * parameters.A));
  }
}

// Along the guide m s'' = -m g sin a - k s.
TEST_CASE("a carriage on a tilted guide oscillates") {
  const gauss::tilted_carriage::Parameters<double> p;
  const double middle = -p.m * p.g * std::sin(p.a) / p.k, frequency = std::sqrt(p.k / p.m);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const Reached found = after<Carriage>(7, tolerance);
    CHECK(found.x == Approx(middle * (1 - std::cos(7 * frequency)) * std::cos(p.a)).margin(1e3 * tolerance));
    CHECK(std::abs(found.turn) < 1e-13);
  }
}

// Where the skate stands upright its blade has no direction on the ice, and holds nothing: how the motion goes on is nobody's to say.
TEST_CASE("a skater stops where his blade is upright, and says so") {
  namespace skater = gauss::skater_quaternion;
  const skater::Prepared<double> prepared = prepare(skater::Parameters<double>{});
  const skater::Inputs<double> inputs{};
  skater::State<double> start;
  REQUIRE(initial_state(prepared, start) == Status::ok);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    gauss::simulate::Settings<double> settings;
    settings.tolerance = tolerance;
    gauss::simulate::Simulation run(gauss::integrate::bind_model<Skater>(prepared, inputs), start, 0.0, settings);
    CHECK_FALSE(run.advance_to(5));
    CHECK(run.report().outcome == gauss::simulate::Outcome::constraints_lost);
    const auto at = run.state();
    const double along_x = 1 - 2 * (at.e2() * at.e2() + at.e3() * at.e3()),
                 along_y = 2 * (at.e1() * at.e2() + at.e0() * at.e3());
    INFO("tolerance " << tolerance << ", stopped at " << run.time());
    CHECK(std::hypot(along_x, along_y) < 1e-3);
  }
}
