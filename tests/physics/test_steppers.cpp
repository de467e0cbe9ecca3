// Steps of one length: orders, symmetry, what corrections do, and what is refused.
#include <cmath>

#include "catch_shim.hpp"
#include "double_pendulum.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/integrate/nystrom_stepper.hpp"
#include "gauss/simulate/assembly.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "pendulum_cartesian.hpp"

GAUSS_MODEL(Double, gauss::double_pendulum);
GAUSS_MODEL(Bob, gauss::pendulum_cartesian);

namespace {

using namespace gauss::integrate;
using gauss::simulate::FixedStep;

auto double_pendulum() {
  return bind_model<Double>(Double::prepare(gauss::double_pendulum::Parameters<double>{}),
                            gauss::double_pendulum::Inputs<double>{});
}
auto bob() {
  return bind_model<Bob>(Bob::prepare(gauss::pendulum_cartesian::Parameters<double>{}),
                         gauss::pendulum_cartesian::Inputs<double>{});
}
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

double distance(const DoubleState& a, const DoubleState& b) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
  return largest;
}

template <class Stepper>
double order(int steps) {
  const DoubleState exact = after_one_second<Prince8<DoubleModel>>(1000);
  return std::log2(distance(after_one_second<Stepper>(steps), exact) /
                   distance(after_one_second<Stepper>(2 * steps), exact));
}

gauss::pendulum_cartesian::State<double> bob_start() {
  gauss::pendulum_cartesian::State<double> start;
  REQUIRE(initial_state(bob().prepared(), start) == gauss::Status::ok);
  return start;
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

TEST_CASE("projection holds the bar and says how far it moved; the energy is kept where speeds can make up for it") {
  using Energy = gauss::pendulum_cartesian::Energy<double>;
  using Kept = EnergyKept<Projected<Rk4<BobModel>>, Energy>;
  FixedStep<BobModel, Kept> run(bob(), bob_start(), 0.01);
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

TEST_CASE("assembly reports what moved, and leaves a start alone that is beyond the limit") {
  auto start = bob_start();
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
