// A ball rolls on a plane, and its axis passes the upright at a distance: the pole of z-x-z Euler angles, which a quaternion does not have.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ball_on_plane.hpp"
#include "ball_on_plane_euler.hpp"
#include "gauss/integrate/euler_charts.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "gauss/simulate/simulation.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(Ball, gauss::ball_on_plane);
GAUSS_MODEL(EulerBall, gauss::ball_on_plane_euler);

namespace {

constexpr double k_rate = 1;      ///< rad/s
constexpr double k_radius = 0.1;  ///< m
constexpr double k_step = 1e-3;   ///< s
constexpr std::int64_t k_steps = 4000;
constexpr double k_pole_at = 1.7;  ///< s: between two steps the axis is nearest to the upright

/// The ball turns about space x all the time, and so moves by v_y = -omega r. The axis, (sin e, -cos e sin a, cos e cos a) with the
/// angle a = omega (t - k_pole_at), is at its least distance e from the upright where a = 0.
struct Axis {
  double distance, angle;
  double x() const { return std::sin(distance); }
  double y() const { return -std::cos(distance) * std::sin(angle); }
  double z() const { return std::cos(distance) * std::cos(angle); }
};

struct Misses {
  double omega = 0;   ///< rad/s
  double centre = 0;  ///< m
  double norm = 0;    ///< of the quaternion, less 1
  std::int64_t steps = 0;
  bool arrives = false;
  double seconds = 0;
};

void measure(double t, const double* centre, double wx, double wy, double wz, Misses& misses) {
  for (const double difference : {wx - k_rate, wy, wz}) grow(misses.omega, difference);
  grow(misses.centre, centre[0]);
  grow(misses.centre, centre[1] + k_rate * k_radius * t);
}

/// Turned by e about y from z, then by -omega k_pole_at about x.
gauss::ball_on_plane::State<double> quaternion_start(double e) {
  gauss::ball_on_plane::State<double> state{};
  const double half = -k_rate * k_pole_at / 2;
  state.e0() = std::cos(half) * std::cos(e / 2);
  state.e1() = std::sin(half) * std::cos(e / 2);
  state.e2() = std::cos(half) * std::sin(e / 2);
  state.e3() = std::sin(half) * std::sin(e / 2);
  state.y_dot() = -k_rate * k_radius;
  state.wx() = k_rate;
  return state;
}

Misses with_quaternion(double e) {
  const auto model = gauss::integrate::bind_model<Ball>();
  using Model = std::decay_t<decltype(model)>;
  Stopwatch stopwatch;
  Misses misses;
  gauss::simulate::FixedStep<Model, gauss::integrate::Rk4<Model>> run(model, quaternion_start(e), k_step);
  misses.arrives = run.advance(k_steps, [&](double t, const auto& state) {
    measure(t, state.values, state.wx(), state.wy(), state.wz(), misses);
    grow(misses.norm, std::sqrt(state.e0() * state.e0() + state.e1() * state.e1() + state.e2() * state.e2() +
                                state.e3() * state.e3()) -
                          1);
  });
  misses.steps = run.steps();
  misses.seconds = stopwatch.seconds();
  return misses;
}

/// Of space x turning with 1: psi' = -sin psi cot theta, theta' = cos psi, phi' = sin psi / sin theta.
gauss::ball_on_plane_euler::State<double> euler_start(double e) {
  const Axis axis{e, -k_rate * k_pole_at};
  gauss::ball_on_plane_euler::State<double> state{};
  const double across = std::hypot(axis.x(), axis.y());
  // The third axis of z-x-z is (sin psi sin theta, -cos psi sin theta, cos theta).
  state.psi() = std::atan2(axis.x(), -axis.y());
  state.theta() = std::atan2(across, axis.z());
  state.y_dot() = -k_rate * k_radius;
  state.psi_dot() = -k_rate * std::sin(state.psi()) * axis.z() / across;
  state.theta_dot() = k_rate * std::cos(state.psi());
  state.phi_dot() = k_rate * std::sin(state.psi()) / across;
  return state;
}

/// omega in space of z-x-z angles.
void measure_euler(double t, const gauss::ball_on_plane_euler::State<double>& at, Misses& misses) {
  const double sin_psi = std::sin(at.psi()), cos_psi = std::cos(at.psi()), sin_theta = std::sin(at.theta());
  measure(t, at.values, at.theta_dot() * cos_psi + at.phi_dot() * sin_theta * sin_psi,
          at.theta_dot() * sin_psi - at.phi_dot() * sin_theta * cos_psi,
          at.psi_dot() + at.phi_dot() * std::cos(at.theta()), misses);
}

Misses with_euler_angles(double e) {
  const auto model = gauss::integrate::bind_model<EulerBall>();
  using Model = std::decay_t<decltype(model)>;
  Stopwatch stopwatch;
  Misses misses;
  gauss::simulate::FixedStep<Model, gauss::integrate::Rk4<Model>> run(model, euler_start(e), k_step);
  misses.arrives = run.advance(k_steps, [&](double t, const auto& state) { measure_euler(t, state, misses); });
  misses.steps = run.steps();
  misses.seconds = stopwatch.seconds();
  return misses;
}

using Zxz = gauss::integrate::EulerSequence<'z', 'x', 'z'>;

/// In the chart that is the better one; `charts` is a stepper or a model.
template <class Charts>
gauss::ball_on_plane_euler::State<double> charted_start(double e, Charts& charts) {
  const auto same = quaternion_start(e);
  gauss::ball_on_plane_euler::State<double> start{};
  charts.place(gauss::integrate::rotation_of<double>({same.e0(), same.e1(), same.e2(), same.e3()}), {k_rate, 0, 0},
               start);
  start.y_dot() = -k_rate * k_radius;
  return start;
}

/// In two charts, which change before a step.
Misses in_charts(double e, long& switches) {
  const auto model = gauss::integrate::bind_model<EulerBall>();
  using Model = std::decay_t<decltype(model)>;
  using Stepper = gauss::integrate::EulerCharts<gauss::integrate::Rk4<Model>, Zxz>;
  Stepper stepper({{2, 3, 4}, {7, 8, 9}});
  const auto start = charted_start(e, stepper);
  Stopwatch stopwatch;
  Misses misses;
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, k_step, 0, stepper);
  misses.arrives = run.advance(k_steps, [&](double t, const auto& state) { measure_euler(t, state, misses); });
  misses.steps = run.steps();
  misses.seconds = stopwatch.seconds();
  switches += run.stepper().report().switches;
  return misses;
}

/// With steps as long as the estimate of their error allows, and projection: it arrives with this error, or says that it does not.
template <class Model>
Misses driven(const Model& model, const gauss::ball_on_plane_euler::State<double>& start) {
  Stopwatch stopwatch;
  Misses misses;
  gauss::simulate::Settings<double> settings;
  settings.most_steps = 100'000;  // it may work its way past a millionth with some more
  gauss::simulate::Simulation<Model> run(model, start, 0.0, settings);
  misses.arrives = run.advance_to(k_step * k_steps,
                                  [&](double t, const auto&, const auto& state) { measure_euler(t, state, misses); });
  misses.steps = run.report().steps;
  misses.seconds = stopwatch.seconds();
  return misses;
}

/// By one chart, and by two.
std::array<Misses, 2> driven(double e) {
  const auto model = gauss::integrate::bind_model<EulerBall>();
  gauss::integrate::InEulerCharts<std::decay_t<decltype(model)>, Zxz> charted(model, {{2, 3, 4}, {7, 8, 9}});
  const auto start = charted_start(e, charted);
  return {driven(model, euler_start(e)), driven(charted, start)};
}

std::string what_euler_does(const Misses& euler) {
  char text[96];
  std::snprintf(text, sizeof text, "Euler angles: %s after %lld of %lld steps, centre off by %.1g m",
                euler.arrives ? "arrives" : "stops", static_cast<long long>(euler.steps),
                static_cast<long long>(k_steps), euler.centre);
  return text;
}

}  // namespace

std::vector<Figure> euler_pole(const Scope&) {
  std::vector<Figure> figures;
  Misses worst, naive_worst, charted, of_driver, of_driver_in_charts;
  double as_far_as_it_goes = 0;
  int refused = 0;
  long switches = 0;
  for (const double e : {0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 0.0}) {
    const Misses euler = with_euler_angles(e), ours = with_quaternion(e);
    char id[24];
    std::snprintf(id, sizeof id, "H01.%g", e);
    Figure figure{id, "omega, axis passes the upright at this distance", "rad/s"};
    // Euler angles resolve a wide passage, and then they are no naive form that fails.
    const double naive = euler.arrives ? euler.omega : k_breaks_down;
    figure.bar = 1e-10;
    if (naive > figure.bar) figure.naive = naive;
    figure.ours = ours.arrives ? ours.omega : k_breaks_down;
    figure.seconds_naive = euler.seconds;
    figure.seconds_ours = ours.seconds;
    figure.remark = what_euler_does(euler);
    figures.push_back(figure);
    const Misses charts = in_charts(e, switches);
    grow(charted.omega, charts.arrives ? charts.omega : k_breaks_down);
    grow(charted.centre, charts.arrives ? charts.centre : k_breaks_down);
    grow(naive_worst.omega, naive);
    charted.seconds += charts.seconds;
    naive_worst.seconds += euler.seconds;
    const auto [driver, driver_in_charts] = driven(e);
    grow(as_far_as_it_goes, driver.omega);
    refused += driver.arrives ? 0 : 1;
    grow(of_driver.omega, driver.arrives ? driver.omega : k_breaks_down);
    grow(of_driver_in_charts.omega, driver_in_charts.arrives ? driver_in_charts.omega : k_breaks_down);
    of_driver.seconds += driver.seconds;
    of_driver_in_charts.seconds += driver_in_charts.seconds;
    grow(worst.centre, ours.arrives ? ours.centre : k_breaks_down);
    grow(worst.norm, ours.arrives ? ours.norm : k_breaks_down);
  }
  figures.push_back({"H01.centre", "way of the centre, all distances", "m", std::nullopt, worst.centre, 1e-10});
  figures.push_back({"H01.norm", "quaternion's length less 1, all distances", "1", std::nullopt, worst.norm, 1e-14});
  figures.push_back({"H01.charts", "omega by Euler angles in two charts, all distances", "rad/s", naive_worst.omega,
                     charted.omega, 1e-10, naive_worst.seconds, charted.seconds,
                     std::to_string(switches) + " changes of the chart in 10 runs"});
  figures.push_back({"H01.charts_centre", "the same: way of the centre", "m", std::nullopt, charted.centre, 1e-10});
  // The pole magnifies what a step may miss by 1/e, and steps below rounding are refused long before all digits are gone.
  figures.push_back({"H01.driver", "omega by Euler angles and steps with an estimate, as far as it goes", "rad/s",
                     std::nullopt, as_far_as_it_goes, 1e-6, 0, 0,
                     "refuses to pass in " + std::to_string(refused) + " of 10 cases"});
  figures.push_back({"H01.driver_charts", "the same in two charts, all distances", "rad/s", of_driver.omega,
                     of_driver_in_charts.omega, 1e-10, of_driver.seconds, of_driver_in_charts.seconds});
  return figures;
}

}  // namespace hard_cases
