// Steps that follow the error, whatever units are: sizes are those of the motion, down to rounding.
#include <cmath>
#include <cstddef>

#include "bound.hpp"
#include "catch_shim.hpp"
#include "double_pendulum.hpp"
#include "gauss/integrate/fastest_rate.hpp"
#include "gauss/model_concept.hpp"
#include "gauss/simulate/assembly.hpp"
#include "gauss/simulate/simulation.hpp"
#include "pendulum_cartesian.hpp"

GAUSS_MODEL(ScaledBob, gauss::pendulum_cartesian);
GAUSS_MODEL(ScaledDouble, gauss::double_pendulum);

namespace {

using gauss::integrate::bind_model;
using gauss::simulate::Outcome;
using gauss::simulate::Settings;
using gauss::simulate::Simulation;
using Bob = gauss::pendulum_cartesian::State<double>;

/// x' = v, v' = push(t) - stiffness x + growth x^2, in the shape of an emitted model, whose units nobody has told.
namespace cart {

template <class S>
struct State {
  S values[2];
};
template <class S>
struct Derivative {
  S values[2];
};
template <class S>
struct Inputs {
  S push = 0;
};
template <class S>
struct Prepared {
  S stiffness = 0, growth = 0;
};
template <class S>
gauss::Status rhs(const S&, const State<S>& state, const Inputs<S>& inputs, const Prepared<S>& p,
                  Derivative<S>& derivative) {
  const S x = state.values[0];
  derivative.values[0] = state.values[1];
  derivative.values[1] = inputs.push - p.stiffness * x + p.growth * x * x;
  return gauss::Status::ok;
}

}  // namespace cart

struct Cart {
  static constexpr int n_q = 1, n_v = 1;
  template <class S>
  using Parameters = cart::Prepared<S>;
  template <class S>
  using Prepared = cart::Prepared<S>;
  template <class S>
  using Inputs = cart::Inputs<S>;
  template <class S>
  using State = cart::State<S>;
  template <class S>
  using Derivative = cart::Derivative<S>;
  template <class S>
  static Prepared<S> prepare(const Parameters<S>& parameters) {
    return parameters;
  }
  template <class S>
  static gauss::Status rhs(const S& t, const State<S>& state, const Inputs<S>& inputs, const Prepared<S>& p,
                           Derivative<S>& result) {
    return cart::rhs(t, state, inputs, p, result);
  }
};

/// `push(t)` is a force.
template <class Push>
auto cart_under(const Push& push, const cart::Prepared<double>& parameters = {}) {
  return bind_model<Cart>(parameters,
                          [push](double t, const cart::State<double>&) { return cart::Inputs<double>{push(t)}; });
}

struct Bobs {
  gauss::pendulum_cartesian::Parameters<double> parameters;
  Bob end;
  long steps;
};

/// The bob for 10 s from rest, with lengths, masses and times 2^length, 2^mass and 2^time times as large in numbers; the end in the usual units.
Bobs swing(int length, int mass, int time) {
  Bobs result{};
  auto& p = result.parameters;
  p.L = std::ldexp(p.L, length);
  p.m = std::ldexp(p.m, mass);
  p.g = std::ldexp(p.g, length - 2 * time);
  const double l = p.L;
  Simulation simulation(bind_model<ScaledBob>(p), Bob{{0.6 * l, -0.8 * l, 0, 0}});
  REQUIRE(simulation.advance_to(std::ldexp(10.0, time)));
  result.end = simulation.state();
  for (int i = 0; i < 4; ++i) result.end.values[i] = std::ldexp(result.end.values[i], i < 2 ? -length : time - length);
  result.steps = simulation.report().steps;
  return result;
}

}  // namespace

TEST_CASE(
    "in other units, 2^40 times as large or as small, a simulation takes the same steps to the same place, bit for "
    "bit") {
  const Bobs usual = swing(0, 0, 0);
  CHECK(usual.steps > 20);
  for (const int length : {-40, 0, 40}) {
    for (const int time : {-40, 0, 40}) {
      const Bobs now = swing(length, 13, time);
      INFO(length << ' ' << time);
      CHECK(now.steps == usual.steps);
      for (int i = 0; i < 4; ++i) CHECK(now.end.values[i] == usual.end.values[i]);
    }
  }
}

TEST_CASE("the fastest rate and an assembled start are the same in other units") {
  for (const int length : {-40, 0, 40}) {
    for (const int time : {-40, 0, 40}) {
      INFO(length << ' ' << time);
      gauss::pendulum_cartesian::Parameters<double> p;
      p.L = std::ldexp(1.0, length);
      p.g = std::ldexp(9.81, length - 2 * time);
      const auto model = bind_model<ScaledBob>(p);
      CHECK(gauss::integrate::fastest_rate(model, 0.0, Bob{{0, -p.L, 0, 0}}) ==
            Approx(std::ldexp(std::sqrt(9.81), -time)).epsilon(0.01));
      Bob start{{0.6 * p.L, -0.85 * p.L, std::ldexp(0.3, length - time), 0}};
      const auto assembly = gauss::simulate::assemble(model, 0.0, start, 1e300);
      REQUIRE(assembly.outcome == gauss::simulate::AssemblyOutcome::assembled);
      CHECK(std::ldexp(std::hypot(start.values[0], start.values[1]), -length) == Approx(1).epsilon(1e-15));
    }
  }
}

TEST_CASE("a rate that only what stands still has is found, too") {
  // Nothing but a damper, at rest at 1 m.
  const auto model = bind_model<Cart>(cart::Prepared<double>{}, [](double, const cart::State<double>& state) {
    return cart::Inputs<double>{-1e7 * state.values[1]};
  });
  CHECK(gauss::integrate::fastest_rate(model, 0.0, cart::State<double>{{1, 0}}) == Approx(1e7).epsilon(0.01));
}

TEST_CASE("a swing of a picometre of a pendulum of a millimetre is followed to six digits, without a setting") {
  gauss::pendulum_cartesian::Parameters<double> parameters;
  parameters.L = 1e-3;
  const double amplitude = 1e-12, rate = std::sqrt(parameters.g / parameters.L);
  Simulation simulation(bind_model<ScaledBob>(parameters), Bob{{amplitude, -parameters.L, 0, 0}});
  for (const double t : {0.01, 0.1, 1.0}) {
    REQUIRE(simulation.advance_to(t));
    CHECK(simulation.state().values[0] == Approx(amplitude * std::cos(rate * t)).epsilon(0).margin(1e-6 * amplitude));
    CHECK(simulation.state().values[2] ==
          Approx(-amplitude * rate * std::sin(rate * t)).epsilon(0).margin(1e-6 * amplitude * rate));
  }
}

TEST_CASE("what hangs at rest, to rounding, is no reason for short steps, and moves when it is pushed") {
  // No coordinate is 0, and forces cancel to rounding alone.
  gauss::double_pendulum::Parameters<double> parameters;
  const auto bound = bind_model<ScaledDouble>(parameters);
  Simulation resting(bound, gauss::double_pendulum::State<double>{{3.141592653589793, -9.42477796076938, 0, 0}});
  REQUIRE(resting.advance_to(2));
  CHECK(resting.report().steps < 200);
  Simulation hanging(bind_model<ScaledBob>(), Bob{{1e-17, -1, 0, 0}});
  REQUIRE(hanging.advance_to(1000));
  CHECK(hanging.report().steps < 30000);
  CHECK(std::abs(hanging.state().values[0]) < 1e-15);
}

TEST_CASE("what rests at 0 begins to move with a force, whenever that begins to act, at the start as well") {
  for (const double at : {0.0, 1e-9, 0.3, 1.0}) {
    for (const double size : {1e-20, 1.0, 1e20}) {
      INFO(at << ' ' << size);
      Simulation simulation(cart_under([&](double t) { return t > at ? size : 0.0; }), {{0, 0}});
      REQUIRE(simulation.advance_to(3));
      const double span = 3 - at;
      CHECK(simulation.state().values[0] == Approx(size * span * span / 2).epsilon(1e-9));
      CHECK(simulation.state().values[1] == Approx(size * span).epsilon(1e-9));
      CHECK(simulation.report().steps < 300);
    }
  }
}

TEST_CASE("a force that grows from nothing more slowly than any power of time is followed") {
  // Its momentum is not elementary: by Simpson's rule.
  const auto push = [](double t) { return t > 0 ? std::exp(-1 / t) : 0.0; };
  Simulation simulation(cart_under(push), {{0, 0}});
  const bool arrives = simulation.advance_to(1);
  INFO(simulation.time() << ' ' << simulation.report().steps << ' ' << simulation.report().rejected);
  REQUIRE(arrives);
  double sum = 0;
  constexpr int k_parts = 1000;
  for (int i = 0; i < k_parts; ++i) {
    const double a = i / double(k_parts), b = (i + 1) / double(k_parts);
    sum += (push(a) + 4 * push((a + b) / 2) + push(b)) / (6 * k_parts);
  }
  CHECK(simulation.state().values[1] == Approx(sum).epsilon(1e-11));
}

TEST_CASE("an edge is stepped over, a pole is not") {
  // x'' = 6 x^2 with x = 1/(1 - t)^2, to infinity at 1 s.
  cart::Prepared<double> parameters;
  parameters.growth = 6;
  Simulation simulation(cart_under([](double) { return 0.0; }, parameters), {{1, 2}});
  CHECK_FALSE(simulation.advance_to(2));
  CHECK(simulation.report().outcome == Outcome::step_too_small);
  CHECK(simulation.time() == Approx(1).margin(1e-6));
  CHECK(simulation.time() < 1.000001);
}

TEST_CASE("an edge before does not help over a pole") {
  cart::Prepared<double> parameters;
  parameters.growth = 6;
  for (const double at : {0.3, 1.0}) {
    Simulation simulation(cart_under([&](double t) { return t > at && t < at + 1 ? 1.0 : 0.0; }, parameters), {{0, 0}});
    CHECK_FALSE(simulation.advance_to(30));
    CHECK(simulation.report().outcome == Outcome::step_too_small);
    CHECK(simulation.time() > at + 1);
    CHECK(simulation.time() < at + 5);
    CHECK(simulation.state().values[0] > 1e5);
  }
}

TEST_CASE("a first step that is a thousand periods long is refused down to one that is none") {
  cart::Prepared<double> parameters;
  parameters.stiffness = 1e18;
  for (const double first : {1e-6, 1e-3, 1.0, 1e6}) {
    Settings<double> settings;
    settings.first_step = first;
    Simulation simulation(cart_under([](double) { return 0.0; }, parameters), {{1, 0}}, 0.0, settings);
    REQUIRE(simulation.advance_to(1e-8));
    INFO(first);
    CHECK(simulation.state().values[0] == Approx(std::cos(10.0)).epsilon(1e-9));
  }
}
