// Steps of one length: orders, symmetry, what corrections do, and what is refused.
#include <cmath>

#include "bound.hpp"
#include "catch_shim.hpp"
#include "double_pendulum.hpp"
#include "elastic_pendulum.hpp"
#include "free_top.hpp"
#include "gauss/integrate/compensated.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/fastest_rate.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/integrate/nystrom_stepper.hpp"
#include "gauss/integrate/reversible_verlet.hpp"
#include "gauss/integrate/rotation_stepper.hpp"
#include "gauss/simulate/assembly.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "pendulum_cartesian.hpp"
#include "simple_pendulum.hpp"

GAUSS_MODEL(Double, gauss::double_pendulum);
GAUSS_MODEL(Bob, gauss::pendulum_cartesian);
GAUSS_MODEL(Swing, gauss::simple_pendulum);
GAUSS_MODEL(Top, gauss::free_top);
GAUSS_MODEL(Elastic, gauss::elastic_pendulum);

namespace {

using namespace gauss::integrate;
using gauss::simulate::FixedStep;
using physics::distance;
using physics::start_of;

auto double_pendulum() { return bind_model<Double>(); }
auto bob() { return bind_model<Bob>(); }
auto top(double spin) {
  gauss::free_top::Parameters<double> parameters;
  if (spin > 0) parameters.A = parameters.B = 1, parameters.C = 1.5;
  return bind_model<Top>(parameters);
}
using TopModel = decltype(top(0));
using DoubleModel = decltype(double_pendulum());
using BobModel = decltype(bob());
using DoubleState = gauss::double_pendulum::State<double>;

const DoubleState k_start{{1.1, -0.7, 0.5, 0.2}};

template <class Stepper>
DoubleState after_one_second(int steps) {
  FixedStep<DoubleModel, Stepper> run(double_pendulum(), k_start, 1.0 / steps);
  REQUIRE(run.advance(steps));
  CHECK(run.time() == 1);
  return run.state();
}

template <class Stepper>
double order(int steps) {
  const DoubleState exact = after_one_second<Prince8<DoubleModel>>(1000);
  return std::log2(distance(after_one_second<Stepper>(steps), exact) /
                   distance(after_one_second<Stepper>(2 * steps), exact));
}

}  // namespace

TEST_CASE("methods have the order that they claim") {
  CHECK(order<Rk4<DoubleModel>>(800) == Approx(4).margin(0.2));
  CHECK(order<Dopri5<DoubleModel>>(400) == Approx(5).margin(0.3));
  CHECK(order<Fehlberg78<DoubleModel>>(20) == Approx(8).margin(0.8));
  CHECK(order<GaussLegendre<DoubleModel, 1>>(200) == Approx(2).margin(0.2));
  CHECK(order<GaussLegendre<DoubleModel, 2>>(100) == Approx(4).margin(0.2));
  CHECK(order<GaussLegendre<DoubleModel, 3>>(50) == Approx(6).margin(0.3));
}

TEST_CASE("an implicit step that is too long is refused, and the state stays") {
  FixedStep<DoubleModel, GaussLegendre<DoubleModel, 2>> run(double_pendulum(), k_start, 2.0);
  CHECK_FALSE(run.advance(1));
  CHECK(run.last().outcome != StepOutcome::taken);
  CHECK(distance(run.state(), k_start) == 0);
  CHECK(run.time() == 0);
}

TEST_CASE("a model whose accelerations depend on speeds is refused by symplectic Nystrom steps") {
  FixedStep<DoubleModel, McLachlan4<DoubleModel>> run(double_pendulum(), k_start, 0.01);
  CHECK_FALSE(run.advance(1));
  CHECK(run.last().outcome == StepOutcome::unsuitable);
}

namespace {

/// x'' = -x, and beyond x = 0.5 a damper, as `piecewise` would have it.
struct Damped {
  using Scalar = double;
  struct State {
    double values[2];
  };
  using Derivative = State;
  static constexpr std::size_t size = 2, n_q = 1, n_v = 1;
  gauss::Status derivative(double, const State& state, Derivative& result) const {
    result.values[0] = state.values[1];
    result.values[1] = -state.values[0] - (state.values[0] > 0.5 ? state.values[1] : 0);
    return gauss::Status::ok;
  }
};

template <class Stepper>
void is_stopped_beyond_the_wall() {
  FixedStep<Damped, Stepper> run(Damped{}, {{0, 1}}, 0.001);
  CHECK_FALSE(run.advance(1000));
  CHECK(run.last().outcome == StepOutcome::unsuitable);
  CHECK(run.steps() > 520);  // asin 0.5 is 0.5236
  CHECK(run.steps() < 524 + 32);
  CHECK_FALSE(run.advance(1));
}

}  // namespace

TEST_CASE("a damper that begins to act on the way is noticed by symplectic Nystrom steps within 32 of them") {
  is_stopped_beyond_the_wall<Verlet<Damped>>();
  is_stopped_beyond_the_wall<McLachlan4<Damped>>();
}

namespace {

/// x'' = -x and a wave in time, in any unit of time.
struct Shaken {
  using Scalar = double;
  struct State {
    double values[2];
  };
  using Derivative = State;
  static constexpr std::size_t size = 2, n_q = 1, n_v = 1;
  double period = 1, phase = 0;
  bool is_square = true;
  gauss::Status derivative(double t, const State& state, Derivative& result) const {
    const double turns = t / period + phase;
    const double wave = is_square ? (turns - std::floor(turns) < 0.5 ? 1 : -1) : std::sin(2 * M_PI * turns);
    result.values[0] = state.values[1];
    result.values[1] = -state.values[0] + wave;
    return gauss::Status::ok;
  }
};

bool is_refused_at_once(const Shaken& model, double step) {
  FixedStep<Shaken, Verlet<Shaken>> run(model, {{0, 1}}, step);
  return !run.advance(1) && run.last().outcome == StepOutcome::unsuitable;
}

}  // namespace

TEST_CASE(
    "a force in time is noticed by symplectic Nystrom steps at the first, whatever its period and the unit of time") {
  for (const double unit : {1e-9, 1.0, 1e9}) {
    for (const double step : {0.001, 0.01, 0.02}) {
      for (const double period : {0.7, 0.1, 0.02, 0.01, 0.7 / 3, 0.001, 1.0, 1e3}) {
        for (const double phase : {0.0, 0.1, 0.25, 0.49, 0.6}) {
          for (const bool is_square : {true, false}) {
            INFO("period " << period << ", phase " << phase << ", step " << step << ", unit " << unit);
            CHECK(is_refused_at_once({period * unit, phase, is_square}, step * unit));
          }
        }
      }
    }
  }
}

TEST_CASE("what depends neither on time nor on speeds is not refused, at any look") {
  FixedStep<Shaken, Verlet<Shaken>> run({1e30, 0.25, true}, {{0, 1}}, 0.01);
  CHECK(run.advance(2000));
}

TEST_CASE("projection holds the bar and says how far it moved; the energy is kept where speeds can make up for it") {
  using Energy = gauss::pendulum_cartesian::Energy<double>;
  using Kept = EnergyKept<Projected<Rk4<BobModel>>, Energy>;
  FixedStep<BobModel, Kept> run(bob(), start_of(bob()), 0.01);
  Energy first, last;
  REQUIRE(bob().energy(0.0, run.state(), first) == gauss::Status::ok);
  REQUIRE(run.advance(10'000));
  REQUIRE(bob().energy(run.time(), run.state(), last) == gauss::Status::ok);
  const double* y = run.state().values;
  CHECK(std::abs(std::hypot(y[0], y[1]) - 1) < 1e-14);
  CHECK(std::abs(y[0] * y[2] + y[1] * y[3]) < 1e-13);
  CHECK(last.total == Approx(first.total).epsilon(1e-8));
  const auto& projected = run.stepper().inner().correction();
  CHECK(projected.applied == 10'000);
  CHECK(projected.largest > 1e-12);
  CHECK(projected.largest < 1e-5);
  const auto& kept = run.stepper().correction();
  CHECK(kept.applied + kept.left_alone == 10'000);
  CHECK(kept.applied > 5'000);
}

TEST_CASE("levels of projection: each holds its own constraints and leaves the other to drift") {
  struct Misses {
    double position, speed;
  };
  const auto misses = [](auto run) {
    REQUIRE(run.advance(1'000));
    const double* y = run.state().values;
    return Misses{std::abs(std::hypot(y[0], y[1]) - 1), std::abs(y[0] * y[2] + y[1] * y[3])};
  };
  using gauss::integrate::ToPositions;
  using gauss::integrate::ToSpeeds;
  const Misses free = misses(FixedStep<BobModel, Rk4<BobModel>>(bob(), start_of(bob()), 0.01));
  const Misses closed =
      misses(FixedStep<BobModel, Projected<Rk4<BobModel>, ToPositions>>(bob(), start_of(bob()), 0.01));
  const Misses along = misses(FixedStep<BobModel, Projected<Rk4<BobModel>, ToSpeeds>>(bob(), start_of(bob()), 0.01));
  CHECK(free.position > 1e-9);
  CHECK(free.speed > 1e-9);
  CHECK(closed.position < 1e-14);
  CHECK(closed.speed > 1e-10);
  CHECK(along.speed < 1e-14);
  CHECK(along.position > 1e-11);
}

TEST_CASE("a level that is out of reach says so, and the other one is nothing to it") {
  auto far = start_of(bob());
  far.values[0] = 1e-3;  // Newton's method overshoots to 500 rods, and halves that in each step
  far.values[1] = 0;
  CHECK(gauss::integrate::ToPositions::apply(bob(), 0.0, far) == gauss::Status::violated_constraints);
  auto open = start_of(bob());
  open.values[1] -= 1e-3;
  open.values[2] += 0.1;
  CHECK(gauss::integrate::ToSpeeds::apply(bob(), 0.0, open) == gauss::Status::ok);
  CHECK(std::abs(open.values[0] * open.values[2] + open.values[1] * open.values[3]) < 1e-15);
  CHECK(gauss::integrate::ToPositions::apply(bob(), 0.0, open) == gauss::Status::ok);
  CHECK(std::abs(std::hypot(open.values[0], open.values[1]) - 1) < 1e-15);
}

TEST_CASE("assembly reports what moved, and leaves a start alone that is beyond the limit") {
  auto start = start_of(bob());
  start.values[1] -= 0.01;
  auto state = start;
  const auto done = gauss::simulate::assemble(bob(), 0.0, state, 0.1);
  CHECK(done.outcome == gauss::simulate::AssemblyOutcome::assembled);
  CHECK(done.largest > 0.005);
  CHECK(std::abs(std::hypot(state.values[0], state.values[1]) - 1) < 1e-14);
  state = start;
  CHECK(gauss::simulate::assemble(bob(), 0.0, state, 1e-3).outcome == gauss::simulate::AssemblyOutcome::moved_too_far);
  CHECK(state.values[1] == start.values[1]);
}

TEST_CASE("a compensated sum has twice the digits, and what somebody else changes starts anew") {
  CompensatedState<double, 1> sums;
  double values[1] = {1}, plain = 1;
  // 1e-17 is below the last digit of 1; a power of two is exact, so the sum is known.
  const double tiny = std::ldexp(1.0, -60), rate[1] = {tiny};
  for (int k = 0; k < 1 << 20; ++k) {
    sums.begin(values);
    sums.advance(rate, 1.0, values);
    plain += tiny;
  }
  CHECK(plain == 1);
  CHECK(values[0] == 1 + std::ldexp(1.0, -40));
  values[0] = 5;
  sums.begin(values);
  CHECK(sums.rest(0) == 0);
}

TEST_CASE("a product is summed with what it rounds to") {
  Compensated<double> sum;
  const double factor = 1 + std::ldexp(1.0, -30);
  sum.add_product(factor, factor);
  CHECK(sum.value == 1 + std::ldexp(1.0, -29));
  CHECK(sum.rest == std::ldexp(1.0, -60));
}

TEST_CASE("wrapping takes whole turns away to twice the digits, and leaves what is within a turn") {
  Compensated<double> angle;
  const double turn = 2 * std::acos(-1.0);
  // What 2 pi is above the double next to it.
  const double rest = 2.4492935982947064e-16;
  for (const double turns : {1.0, -3.0, 1000.0, 400'000.0}) {
    angle = {turns * turn + 1, 0};
    const double exact = std::fma(-turns, turn, angle.value) - turns * rest;
    angle.wrap();
    CHECK(angle.value + angle.rest == Approx(exact).epsilon(0).margin(1e-15));
  }
  angle = {3, 1e-17};
  angle.wrap();
  CHECK(angle.value == 3);
  CHECK(angle.rest == 1e-17);
}

TEST_CASE("wrapping in float takes whole turns away to twice the digits of float") {
  Compensated<float> angle;
  const double turn = 2 * std::acos(-1.0);
  for (const float turns : {1.0F, -3.0F, 124.0F, 2000.0F}) {
    angle = {turns * static_cast<float>(turn) + 1, 0};
    const double exact = static_cast<double>(angle.value) - static_cast<double>(turns) * turn;
    angle.wrap();
    CHECK(static_cast<double>(angle.value) + static_cast<double>(angle.rest) == Approx(exact).epsilon(0).margin(1e-11));
  }
}

TEST_CASE("a symmetric method keeps the energy to rounding, which does not add up") {
  using Energy = gauss::double_pendulum::Energy<double>;
  FixedStep<DoubleModel, GaussLegendre<DoubleModel, 3>> run(double_pendulum(), k_start, 1e-3);
  Energy first, last;
  REQUIRE(double_pendulum().energy(0.0, run.state(), first) == gauss::Status::ok);
  REQUIRE(run.advance(20'000));
  REQUIRE(double_pendulum().energy(run.time(), run.state(), last) == gauss::Status::ok);
  CHECK(last.total == Approx(first.total).epsilon(0).margin(2e-14));
}

TEST_CASE("rotations of a body that tumbles have order 4, and quaternions keep their length") {
  gauss::free_top::State<double> start;
  REQUIRE(initial_state(top(0).prepared(), start) == gauss::Status::ok);
  const auto after = [&](auto stepper, int steps) {
    FixedStep<TopModel, decltype(stepper)> run(top(0), start, 4.0 / steps, 0, stepper);
    REQUIRE(run.advance(steps));
    return run.state();
  };
  RotationRk4<TopModel> rotations;
  rotations.turn(3);
  const auto exact = after(Prince8<TopModel>(), 2000);
  const auto error = [&](int steps) {
    const auto state = after(rotations, steps);
    CHECK(std::abs(
              std::hypot(std::hypot(state.values[3], state.values[4]), std::hypot(state.values[5], state.values[6])) -
              1) < 1e-13);
    double largest = 0;
    for (int i = 3; i < 7; ++i) largest = std::max(largest, std::abs(state.values[i] - exact.values[i]));
    return largest;
  };
  CHECK(std::log2(error(200) / error(400)) == Approx(4).margin(0.2));
}

TEST_CASE("steps that do not resolve the fastest motion are refused by who is asked to look") {
  gauss::free_top::State<double> start;
  REQUIRE(initial_state(top(1).prepared(), start) == gauss::Status::ok);
  start.float_wx() = start.float_wy() = 0.1;
  start.float_wz() = 1e5;
  // Half of the spin turns the quaternion, and (C - A)/A of it the angular velocity.
  CHECK(fastest_rate(top(1), 0.0, start) == Approx(5e4).epsilon(0.05));
  FixedStep<TopModel, Resolved<Rk4<TopModel>>> refused(top(1), start, 1e-3);
  CHECK_FALSE(refused.advance(1));
  CHECK(refused.last().outcome == StepOutcome::too_long);
  CHECK(refused.stepper().rate() == Approx(5e4).epsilon(0.05));
  FixedStep<TopModel, Resolved<Rk4<TopModel>>> fine(top(1), start, 1e-6);
  CHECK(fine.advance(50));
  // A pendulum of 1 m at rest below.
  CHECK(fastest_rate(bob(), 0.0, gauss::pendulum_cartesian::State<double>{{0, -1, 0, 0}}) ==
        Approx(std::sqrt(9.81)).epsilon(0.05));
}

TEST_CASE("symplectic methods have their orders, and go back where they came from") {
  const auto model = bind_model<Swing>();
  using Model = std::decay_t<decltype(model)>;
  const gauss::simple_pendulum::State<double> start{{1, 0.2}};
  const auto after = [&](auto stepper, int steps) {
    FixedStep<Model, decltype(stepper)> run(model, start, 1.0 / steps);
    REQUIRE(run.advance(steps));
    const double there = run.state().values[0];
    run.turn_back();
    REQUIRE(run.advance(steps));
    CHECK(std::abs(run.state().values[0] - 1) < 1e-12);
    return there;
  };
  FixedStep<Model, Prince8<Model>> reference(model, start, 1e-3);
  REQUIRE(reference.advance(1000));
  const double exact = reference.state().values[0];
  const auto order = [&](auto stepper) {
    return std::log2(std::abs(after(stepper, 100) - exact) / std::abs(after(stepper, 200) - exact));
  };
  CHECK(order(Verlet<Model>()) == Approx(2).margin(0.1));
  CHECK(order(ReversibleVerlet<Model>(4, 8)) == Approx(2).margin(0.1));
  CHECK(order(McLachlan4<Model>()) == Approx(4).margin(0.3));
}

TEST_CASE("steps on a grid bring a chaotic motion back to the bit, and refuse what leaves it") {
  const auto model = bind_model<Elastic>();
  using Model = std::decay_t<decltype(model)>;
  // Not on the grid: the first step moves it there.
  const Model::State start{{0.5 + 1e-16, 1.0 / 3, 0.1, -0.2}};
  FixedStep<Model, ReversibleVerlet<Model>> run(model, start, 0.01, 0, ReversibleVerlet<Model>(4, 16));
  REQUIRE(run.advance(5'000));
  run.turn_back();
  REQUIRE(run.advance(5'000));
  for (std::size_t i = 0; i < Model::size; ++i)
    CHECK(run.state().values[i] == Approx(start.values[i]).epsilon(0).margin(4e-15));
  const Model::State on_grid = run.state();
  run.turn_back();
  REQUIRE(run.advance(5'000));
  run.turn_back();
  REQUIRE(run.advance(5'000));
  for (std::size_t i = 0; i < Model::size; ++i) CHECK(run.state().values[i] == on_grid.values[i]);

  FixedStep<Model, ReversibleVerlet<Model>> beyond(model, start, 0.01, 0, ReversibleVerlet<Model>(4, 1));
  CHECK_FALSE(beyond.advance(100));
  CHECK(beyond.last().outcome == StepOutcome::unsuitable);
  // On this grid a step moves coordinates and speeds by three units, or by none.
  for (const double reach : {1e11, 1e12, 1e14}) {
    FixedStep<Model, ReversibleVerlet<Model>> too_small(model, start, 0.01, 0, ReversibleVerlet<Model>(reach, reach));
    CHECK_FALSE(too_small.advance(1));
    CHECK(too_small.last().outcome == StepOutcome::unsuitable);
  }
  FixedStep<DoubleModel, ReversibleVerlet<DoubleModel>> of_angles(double_pendulum(), k_start, 0.01);
  CHECK_FALSE(of_angles.advance(1));
  CHECK(of_angles.last().outcome == StepOutcome::unsuitable);
}
