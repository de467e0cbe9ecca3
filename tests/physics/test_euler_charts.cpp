// Euler angles in two charts: the same motion as by a quaternion, at the pole, through it and far from it.
#include <array>
#include <cmath>

#include "ball_on_plane_euler.hpp"
#include "bound.hpp"
#include "catch_shim.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/euler_charts.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/model_concept.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "gauss/simulate/simulation.hpp"
#include "heavy_body_euler.hpp"
#include "heavy_body_quaternion.hpp"
#include "sphere_in_cylinder.hpp"
#include "sphere_in_cylinder_quaternion.hpp"

GAUSS_MODEL(AngleBall, gauss::sphere_in_cylinder);
GAUSS_MODEL(SpinBall, gauss::sphere_in_cylinder_quaternion);
GAUSS_MODEL(AngleBody, gauss::heavy_body_euler);
GAUSS_MODEL(SpinBody, gauss::heavy_body_quaternion);
GAUSS_MODEL(AngleRoller, gauss::ball_on_plane_euler);

namespace {

using namespace gauss::integrate;
using gauss::simulate::FixedStep;
using physics::grow;
using Zxz = EulerSequence<'z', 'x', 'z'>;
using Zyx = EulerSequence<'z', 'y', 'x'>;
using Axes = Rotation<double>;
using Vector = Vector3<double>;

constexpr double k_pi = 3.14159265358979323846;

double distance(const Axes& a, const Axes& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) grow(largest, a[i][j] - b[i][j]);
  return largest;
}
double distance(const Vector& a, const Vector& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) grow(largest, a[i] - b[i]);
  return largest;
}

Axes attitude_at(const double* q) { return rotation_of<double>({q[0], q[1], q[2], q[3]}); }

/// psi, theta, phi in that order; components as in the model.
const EulerPlaces k_of_ball{{3, 4, 2}, {8, 9, 7}};

using AngleModel = decltype(bind_model<AngleBall>());
using SpinModel = decltype(bind_model<SpinBall>());
template <class Model>
using Gauss = GaussLegendre<Model, 3>;
using Charts = EulerCharts<Gauss<AngleModel>, Zxz>;

constexpr double k_step = 2e-4;
constexpr int k_steps = 50'000;

/// At chi = 0: rolling makes it so that the ball turns by (2, 7, -20) rad/s.
struct Start {
  AngleModel::State euler{};
  SpinModel::State spin{};
};

Start start_at(double nutation) {
  const double psi = 5.75, phi = 0.3;
  Start start;
  start.euler.chi_dot() = start.spin.chi_dot() = 4;
  start.euler.zeta_dot() = start.spin.zeta_dot() = 0.7;
  start.spin.e0() = std::cos(nutation / 2) * std::cos((psi + phi) / 2);
  start.spin.e1() = std::sin(nutation / 2) * std::cos((psi - phi) / 2);
  start.spin.e2() = std::sin(nutation / 2) * std::sin((psi - phi) / 2);
  start.spin.e3() = std::cos(nutation / 2) * std::sin((psi + phi) / 2);
  start.spin.wx() = 2;
  start.spin.wy() = 7;
  start.spin.wz() = -20;
  return start;
}

struct Misses {
  double places = 0, attitude = 0, angular_velocity = 0;
  long switches = 0;
};

/// The places, attitude and angular velocity of the two descriptions, at one time.
template <class Chart>
void compare(const AngleModel::State& a, const SpinModel::State& b, const Chart& chart, Misses& largest) {
  const double around = a.chi() - b.chi();
  for (const double miss : {around - 2 * k_pi * std::round(around / (2 * k_pi)), a.zeta() - b.zeta(),
                            a.chi_dot() - b.chi_dot(), a.zeta_dot() - b.zeta_dot()})
    grow(largest.places, miss);
  grow(largest.attitude, distance(chart.attitude(a), attitude_at(&b.e0())));
  grow(largest.angular_velocity, distance(chart.angular_velocity(a), {b.wx(), b.wy(), b.wz()}));
}

void check(const Misses& misses, double nutation) {
  INFO("nutation " << nutation << ": " << misses.places << ' ' << misses.attitude << ' ' << misses.angular_velocity
                   << ", " << misses.switches << " switches");
  CHECK(misses.places < 1e-10);
  CHECK(misses.attitude < 1e-10);
  CHECK(misses.angular_velocity < 1e-10);
}

/// Both descriptions side by side for 10 s. The azimuth is summed to twice the digits: what the rounding of 40 rad adds up to is
/// 1e-10 with other steppers, in either description, and the angular velocity of 130 rad/s turns with it.
Misses compare(double nutation) {
  Start start = start_at(nutation);
  Gauss<AngleModel> of_angles;
  Gauss<SpinModel> of_spin;
  of_angles.wrap(0);
  of_spin.wrap(0);
  Charts charts(k_of_ball, of_angles);
  charts.place(attitude_at(&start.spin.e0()), {2, 7, -20}, start.euler);
  FixedStep<AngleModel, Charts> angles(bind_model<AngleBall>(), start.euler, k_step, 0, charts);
  FixedStep<SpinModel, Gauss<SpinModel>> spin(bind_model<SpinBall>(), start.spin, k_step, 0, of_spin);
  Misses largest;
  for (int k = 0; k < k_steps; ++k) {
    REQUIRE(angles.advance(1));
    REQUIRE(spin.advance(1));
    compare(angles.state(), spin.state(), angles.stepper(), largest);
  }
  largest.switches = angles.stepper().report().switches;
  return largest;
}

/// Angles by steps that follow an estimate of their error, in two charts, beside the quaternion for 5 s.
Misses compare_following(double nutation) {
  using Charted = InEulerCharts<AngleModel, Zxz>;
  Start start = start_at(nutation);
  Charted charted(bind_model<AngleBall>(), k_of_ball);
  charted.place(attitude_at(&start.spin.e0()), {2, 7, -20}, start.euler);
  gauss::simulate::Settings<double> settings;
  settings.tolerance = 1e-14;
  gauss::simulate::Simulation<Charted> angles(charted, start.euler, 0, settings);
  Gauss<SpinModel> of_spin;
  of_spin.wrap(0);
  FixedStep<SpinModel, Gauss<SpinModel>> spin(bind_model<SpinBall>(), start.spin, k_step, 0, of_spin);
  Misses largest;
  for (int k = 0; k < k_steps / 2; k += 100) {
    REQUIRE(spin.advance(100));
    REQUIRE(angles.advance_to(spin.time()));
    compare(angles.state(), spin.state(), angles.model(), largest);
  }
  largest.switches = angles.model().switches();
  return largest;
}

template <class Sequence>
void check_sequence() {
  for (const Vector& angles : {Vector{0.3, 1.1, -2.0}, {-2.9, 0.4, 3.0}, {1.5, 0.9, 0.0}}) {
    const Axes r = Sequence::rotation(angles);
    CHECK(distance(Sequence::angles(r), angles) < 1e-14);
    const Vector rates{0.7, -1.3, 0.4};
    const Vector omega = Sequence::angular_velocity(angles, rates);
    CHECK(distance(Sequence::rates(angles, omega), rates) < 1e-14);
    // dR/dt = [omega] R, by central differences.
    constexpr double h = 1e-6;
    Vector before = angles, after = angles;
    for (std::size_t i = 0; i < 3; ++i) before[i] -= h * rates[i], after[i] += h * rates[i];
    const Axes cross = {{{0, -omega[2], omega[1]}, {omega[2], 0, -omega[0]}, {-omega[1], omega[0], 0}}};
    const Axes left = Sequence::rotation(before), right = Sequence::rotation(after);
    Axes slope{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) slope[i][j] = (right[i][j] - left[i][j]) / (2 * h);
    CHECK(distance(slope, product(cross, r)) < 1e-9);
  }
}

}  // namespace

TEST_CASE("angles and rates of all twelve sequences come back from matrix and angular velocity") {
  check_sequence<Zxz>();
  check_sequence<EulerSequence<'x', 'y', 'x'>>();
  check_sequence<EulerSequence<'y', 'z', 'y'>>();
  check_sequence<EulerSequence<'z', 'y', 'z'>>();
  check_sequence<EulerSequence<'x', 'z', 'x'>>();
  check_sequence<EulerSequence<'y', 'x', 'y'>>();
  check_sequence<Zyx>();
  check_sequence<EulerSequence<'x', 'y', 'z'>>();
  check_sequence<EulerSequence<'y', 'z', 'x'>>();
  check_sequence<EulerSequence<'z', 'x', 'y'>>();
  check_sequence<EulerSequence<'x', 'z', 'y'>>();
  check_sequence<EulerSequence<'y', 'x', 'z'>>();
}

TEST_CASE("the ball in the cylinder is one motion in both descriptions, at any nutation including 0 and pi") {
  for (const double nutation : {0.0, 1e-12, 1e-8, 1e-4, 1e-2, 0.1, 0.5, 1.5, 3.0, k_pi - 1e-9, k_pi}) {
    check(compare(nutation), nutation);
  }
}

TEST_CASE("steps that follow an estimate of their error go through the pole, too") {
  long switches = 0;
  for (const double nutation : {0.0, 1e-8, 1e-4, 0.1, 1.5, k_pi}) {
    const Misses misses = compare_following(nutation);
    check(misses, nutation);
    switches += misses.switches;
  }
  CHECK(switches > 15);
}

TEST_CASE("angles at their pole are taken as they are written: the first step changes the chart") {
  using Model = decltype(bind_model<AngleRoller>());
  using Stepper = EulerCharts<Rk4<Model>, Zxz>;
  // x, y, psi, theta, phi: upright, and rolling along -y.
  Model::State start{};
  start.theta_dot() = 1;
  start.y_dot() = -0.1;
  FixedStep<Model, Stepper> run(bind_model<AngleRoller>(), start, 1e-3, 0, Stepper({{2, 3, 4}, {7, 8, 9}}));
  REQUIRE(run.advance(1));
  CHECK(run.stepper().report().switches == 1);
  CHECK(run.stepper().is_turned());
  REQUIRE(run.advance(10'000));
  CHECK(distance(run.stepper().angular_velocity(run.state()), {1, 0, 0}) < 1e-10);
  CHECK(std::abs(run.state().y() + 0.1 * run.time()) < 1e-10);
  const double half = run.time() / 2;
  CHECK(distance(run.stepper().attitude(run.state()), rotation_of<double>({std::cos(half), std::sin(half), 0, 0})) <
        1e-10);
  // From one pole to the other, a quarter turn apart.
  CHECK(run.stepper().report().switches == 7);
  const Axes quarter = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
  CHECK(distance(run.stepper().behind(), quarter) == 0);
}

TEST_CASE("a step that is not taken leaves the state and the chart") {
  using Model = decltype(bind_model<AngleRoller>());
  struct Refusing {
    using Scalar = double;
    using State = Model::State;
    StepResult step(const Model&, double, double, State& state) {
      state.values[0] = 7;
      return {StepOutcome::not_converged, gauss::Status::ok};
    }
  };
  EulerCharts<Refusing, Zxz> charts({{2, 3, 4}, {7, 8, 9}});
  Model::State state{};
  state.theta_dot() = 1;
  const Model::State before = state;
  CHECK_FALSE(charts.step(bind_model<AngleRoller>(), 0, 1e-3, state).is_taken());
  for (std::size_t i = 0; i < Model::size; ++i) CHECK(state.values[i] == before.values[i]);
  CHECK_FALSE(charts.is_turned());
  CHECK(charts.report().switches == 0);
}

TEST_CASE(
    "a body with three moments of inertia has a frame behind its angles, and other parameters in the other chart") {
  using Model = decltype(bind_model<AngleBody>());
  using Spin = decltype(bind_model<SpinBody>());
  using Inner = Prince8<Model>;
  using Stepper = EulerCharts<Inner, Zyx, gauss::heavy_body_euler::Prepared<double>>;
  CHECK(Stepper::p == 1);
  const gauss::heavy_body_euler::Parameters<double> upright;
  gauss::heavy_body_euler::Parameters<double> turned;
  turned.behind = Stepper::k_behind;
  const Stepper::PreparedInCharts in_charts = {AngleBody::prepare(upright), AngleBody::prepare(turned)};
  long switches = 0;
  for (const double pitch : {0.0, 1.0, k_pi / 2, k_pi / 2 - 1e-9, -k_pi / 2}) {
    Stepper stepper({{0, 1, 2}, {3, 4, 5}}, Inner(), in_charts);
    Spin::State spin{};
    spin.values[0] = std::cos(pitch / 2);
    spin.values[2] = std::sin(pitch / 2);
    const Vector in_body{3, -2, 5};
    for (std::size_t i = 0; i < 3; ++i) spin.values[4 + i] = in_body[i];
    const auto in_space = [&](const Spin::State& state) {
      const Axes r = attitude_at(state.values);
      Vector omega{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) omega[i] += r[i][j] * state.values[4 + j];
      return omega;
    };
    Model::State start{};
    stepper.place(attitude_at(spin.values), in_space(spin), start);
    using Charted = InEulerCharts<Model, Zyx, gauss::heavy_body_euler::Prepared<double>>;
    Charted charted(bind_model<AngleBody>(), {{0, 1, 2}, {3, 4, 5}}, in_charts);
    charted.place(attitude_at(spin.values), in_space(spin), start);
    gauss::simulate::Settings<double> settings;
    settings.tolerance = 1e-13;
    gauss::simulate::Simulation<Charted> following(charted, start, 0, settings);
    FixedStep<Model, Stepper> angles(bind_model<AngleBody>(), start, k_step, 0, stepper);
    FixedStep<Spin, Projected<Prince8<Spin>>> rotating(bind_model<SpinBody>(), spin, k_step);
    double attitude = 0, omega = 0;
    for (int k = 0; k < 25'000; ++k) {
      REQUIRE(angles.advance(1));
      REQUIRE(rotating.advance(1));
      grow(attitude, distance(angles.stepper().attitude(angles.state()), attitude_at(rotating.state().values)));
      grow(omega, distance(angles.stepper().angular_velocity(angles.state()), in_space(rotating.state())));
    }
    REQUIRE(following.advance_to(rotating.time()));
    grow(attitude, distance(following.model().attitude(following.state()), attitude_at(rotating.state().values)));
    grow(omega, distance(following.model().angular_velocity(following.state()), in_space(rotating.state())));
    INFO(pitch << ": " << attitude << ' ' << omega << ", " << angles.stepper().report().switches << " switches, "
               << following.model().switches());
    CHECK(attitude < 1e-10);
    CHECK(omega < 1e-10);
    switches += angles.stepper().report().switches + following.model().switches();
  }
  CHECK(switches > 20);
}
