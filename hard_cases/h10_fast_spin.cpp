// A top with 1e5 rad/s, in steps of a millisecond, for 1e5 turns.

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>

#include "fast_top.hpp"
#include "free_top.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/fastest_rate.hpp"
#include "gauss/integrate/rotation_stepper.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(FastTop, gauss::fast_top);
GAUSS_MODEL(FreeTop, gauss::free_top);

namespace {

constexpr double k_step = 1e-3;
constexpr double k_spin = 1e5;                 // rad/s
constexpr double k_across = 0.1;               // rad/s
constexpr std::int64_t k_steps = 6284;         // 1e5 turns
constexpr double k_explicit_duration = 0.628;  // s: 1e4 turns

/// Angular velocity across the axis, in the axes of the body: it turns by (C - A)/A n, theory of the free symmetric top.
double across_error(double wx, double wy, double t) {
  const double angle = 0.5 * k_spin * t;
  return std::hypot(wx - k_across * std::cos(angle), wy - k_across * std::sin(angle)) / k_across;
}

/// Euler's equations by hand, A wx' = (A - C) wy wz and so on, in RK4's steps, which are stable up to 2.8 by the fastest rate and from 1 on take that motion
/// away within some hundred steps, without a word. Largest error on the way.
double silent_error(double step) {
  using Three = std::array<double, 3>;
  boost::numeric::odeint::runge_kutta4<Three> method;
  Three w = {k_across, 0, k_spin};
  double error = 0;
  const auto euler = [](const Three& x, Three& rate, double) { rate = {-x[1] * x[2] / 2, x[0] * x[2] / 2, 0}; };
  const std::int64_t steps = std::llround(k_explicit_duration / step);
  for (std::int64_t k = 1; k <= steps; ++k) {
    method.do_step(euler, w, 0.0, step);
    grow(error, across_error(w[0], w[1], static_cast<double>(k) * step));
  }
  return error;
}

/// 0 where the step is refused for its length before it is taken.
double refused_error(double step) {
  gauss::free_top::Parameters<double> parameters;
  parameters.A = parameters.B = 1;
  parameters.C = 1.5;
  const auto model = gauss::integrate::bind_model<FreeTop>(parameters);
  using Model = std::decay_t<decltype(model)>;
  gauss::free_top::State<double> start{};
  start.float_e0() = 1;
  start.float_wx() = k_across;
  start.float_wz() = k_spin;
  gauss::simulate::FixedStep<Model, gauss::integrate::Resolved<gauss::integrate::Rk4<Model>>> run(model, start, step);
  run.advance(1);
  return run.last().outcome == gauss::integrate::StepOutcome::too_long && run.steps() == 0 ? 0 : k_breaks_down;
}

Figure refused() {
  Figure figure{"H10.refused",
                "angular velocity across the axis, of what an explicit form returns without a word",
                "1",
                std::nullopt,
                0,
                1e-6};
  double naive = 0;
  for (const double product : {1.1, 1.7, 2.3, 2.8}) {
    grow(naive, silent_error(product / (k_spin / 2)));
    grow(figure.ours, refused_error(product / (k_spin / 2)));
  }
  grow(figure.ours, refused_error(k_step));
  figure.naive = naive;
  figure.remark =
      "1e4 turns in steps of 1.1 to 2.8 by the fastest rate; naive: RK4 there; ours: refused, as steps of 50 are";
  return figure;
}

/// Largest of the errors that the two functions say, over the run.
struct Errors {
  double across = 0;
  double axis = 0;
  double seconds = 0;
};

template <class Stepper, class Model>
Errors reduced_form(const Model& model, const typename Model::State& start, Stepper stepper) {
  const gauss::fast_top::Parameters<double> p;
  const double frame = p.C / p.A * p.n;
  const double rate = std::hypot(k_across, frame);
  Errors errors;
  Stopwatch stopwatch;
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, k_step, 0, std::move(stepper));
  const bool arrives = run.advance(k_steps, [&](double t, const auto& s) {
    const double c = std::cos(s.chi()), d = std::sin(s.chi());
    const double wx = c * s.gimbal_wx() + d * s.gimbal_wy(), wy = c * s.gimbal_wy() - d * s.gimbal_wx();
    const double across = across_error(wx, wy, t);
    if (!(across <= errors.across)) errors.across = across;
    // The frame turns about one axis: q = cos(rate t/2) + sin(rate t/2) omega/rate, so the top's axis is known.
    const double half = rate * t / 2, x = std::sin(half) * k_across / rate, z = std::sin(half) * frame / rate;
    const double exact_x = 2 * x * z, exact_y = -2 * std::cos(half) * x;
    const double axis_x = 2 * (s.gimbal_e1() * s.gimbal_e3() + s.gimbal_e0() * s.gimbal_e2());
    const double axis_y = 2 * (s.gimbal_e2() * s.gimbal_e3() - s.gimbal_e0() * s.gimbal_e1());
    const double axis = std::hypot(axis_x - exact_x, axis_y - exact_y) / (2 * k_across / rate);
    if (!(axis <= errors.axis)) errors.axis = axis;
  });
  if (!arrives) errors.across = errors.axis = k_breaks_down;
  errors.seconds = stopwatch.seconds();
  return errors;
}

}  // namespace

std::vector<Figure> fast_spin(const Scope&) {
  const auto prepared = FastTop::prepare(gauss::fast_top::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<FastTop>(prepared, gauss::fast_top::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  gauss::fast_top::State<double> start;
  if (initial_state(prepared, start) != gauss::Status::ok) return {};
  gauss::integrate::RotationRk4<Model> rotations;
  rotations.turn(1);
  const Errors naive = reduced_form(model, start, gauss::integrate::Rk4<Model>());
  const Errors ours = reduced_form(model, start, rotations);
  return {{"H10.across",
           "angular velocity across the axis in 1e5 turns, in body axes, by its size",
           "1",
           naive.across,
           ours.across,
           1e-6,
           naive.seconds,
           ours.seconds,
           "frame of the nutation; naive: RK4 there",
           {}},
          {"H10.axis",
           "direction of the axis, by the opening of its cone",
           "1",
           naive.axis,
           ours.axis,
           1e-6,
           naive.seconds,
           ours.seconds,
           "",
           {}},
          refused()};
}

}  // namespace hard_cases
