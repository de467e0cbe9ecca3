// Rates of 1e6/s and 1e9/s beside a motion of 1/s, with steps of a millisecond; and the emitted Jacobian that implicit methods live on.

#include <algorithm>
#include <cmath>
#include <complex>

#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/sdirk.hpp"
#include "gauss/scalar/dual.hpp"
#include "gauss/simulate/cvode.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"
#include "stiff_relaxation.hpp"
#include "stiff_spring.hpp"

namespace hard_cases {

GAUSS_MODEL(Relaxation, gauss::stiff_relaxation);
GAUSS_MODEL(StiffSpring, gauss::stiff_spring);

namespace {

constexpr double k_step = 1e-3;
constexpr double k_duration = 10;
constexpr double k_tolerance = 1e-9;

struct Run {
  double error = k_breaks_down;
  double seconds = 0;
  long steps = 0;
};

/// Largest error over steps of k_step, as `error(t, state)` says.
template <class Stepper, class Model, class Error>
Run in_steps(const Model& model, const typename Model::State& start, Error&& error) {
  Stopwatch stopwatch;
  Run result{0, 0, 0};
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, k_step);
  const bool arrives = run.advance(std::llround(k_duration / k_step), [&](double t, const auto& state) {
    const double now = error(t, state);
    if (!(now <= result.error)) result.error = now;
  });
  if (!arrives || !(result.error <= std::numeric_limits<double>::max())) result.error = k_breaks_down;
  result.seconds = stopwatch.seconds();
  result.steps = run.steps();
  return result;
}

template <class Derivatives, class Model, class Error>
Run by_bdf(const Model& model, const typename Model::State& start, Error&& error) {
  Stopwatch stopwatch;
  gauss::simulate::Settings<double> settings;
  settings.tolerance = k_tolerance;
  Run result{0, 0, 0};
  gauss::simulate::CvodeSimulation<Model, Derivatives> run(model, start, 0, settings);
  const bool arrives = run.advance_to(
      k_duration, [&](double t, const auto& state) { result.error = std::max(result.error, error(t, state)); });
  if (!arrives) result.error = k_breaks_down;
  result.seconds = stopwatch.seconds();
  result.steps = run.report().steps;
  return result;
}

/// CVODE as it comes: BDF with one tolerance for all components, relative and absolute.
template <class Derivatives, class Model>
Run by_plain_cvode(const Model& model, const typename Model::State& start) {
  using Problem = gauss::integrate::sundials::Problem<Model, Derivatives>;
  constexpr long k_most_steps = 2'000'000;
  const Stopwatch stopwatch;
  Problem problem;
  problem.set_model(model);
  const gauss::integrate::sundials::Workspace work(static_cast<sunindextype>(Model::size));
  N_Vector y = work.state.get();
  std::copy_n(start.values, Model::size, N_VGetArrayPointer(y));
  void* cvode = CVodeCreate(CV_BDF, work.context.get());
  CVodeInit(cvode, Problem::rates, 0, y);
  CVodeSetUserData(cvode, &problem);
  CVodeSStolerances(cvode, k_tolerance, k_tolerance);
  CVodeSetLinearSolver(cvode, work.solver.get(), work.matrix.get());
  CVodeSetJacFn(cvode, Problem::jacobian);
  CVodeSetMaxNumSteps(cvode, k_most_steps);
  sunrealtype reached = 0;
  Run result;
  CVode(cvode, k_duration, y, &reached, CV_NORMAL);
  CVodeGetNumSteps(cvode, &result.steps);
  CVodeFree(&cvode);
  result.seconds = stopwatch.seconds();
  return result;
}

/// RK4 against SDIRK and BDF.
template <class Derivatives, class Model, class Error>
void compare(const std::string& id, const std::string& quantity, const char* unit, const Model& model,
             const typename Model::State& start, Error&& error, std::vector<Figure>& figures) {
  using gauss::integrate::Rk4;
  using gauss::integrate::Sdirk;
  const Run naive = in_steps<Rk4<Model>>(model, start, error);
  const Run sdirk = in_steps<Sdirk<Model, Derivatives>>(model, start, error);
  const Run bdf = by_bdf<Derivatives>(model, start, error);
  const auto add = [&](const char* method, const Run& ours) {
    figures.push_back({id + "." + method,
                       quantity + ", in 10 s",
                       unit,
                       naive.error,
                       ours.error,
                       1e-8,
                       naive.seconds,
                       ours.seconds,
                       "naive: RK4; " + std::to_string(ours.steps) + " steps",
                       {}});
  };
  add("sdirk", sdirk);
  add("bdf", bdf);
}

void relaxation(std::vector<Figure>& figures) {
  namespace emitted = gauss::stiff_relaxation;
  using Derivatives = gauss::integrate::EmittedJacobian<emitted::Jacobian<double>, emitted::JacobianByState>;
  const auto model = gauss::integrate::bind_model<Relaxation>();
  const auto error = [](double t, const auto& state) { return std::abs(state.values[1] - std::cos(t)); };
  compare<Derivatives>("H15.drag", "speed beside cos t", "m/s", model, emitted::State<double>{{0, 1}}, error, figures);
}

void spring(std::vector<Figure>& figures) {
  namespace emitted = gauss::stiff_spring;
  using Derivatives = gauss::integrate::EmittedJacobian<emitted::Jacobian<double>, emitted::JacobianByState>;
  const emitted::Parameters<double> parameters;
  const auto model = gauss::integrate::bind_model<StiffSpring>(parameters);
  // What is left when the rest has decayed: m s'' + c s' + k s = k U cos(w t) is solved by the real part of A exp(i w t).
  const double w = parameters.w;
  const std::complex<double> amplitude =
      parameters.k * parameters.U / std::complex<double>(parameters.k - parameters.m * w * w, parameters.c * w);
  const auto place = [&](double t) { return std::real(amplitude * std::polar(1.0, w * t)); };
  const emitted::State<double> start{{place(0), std::real(std::complex<double>(0, w) * amplitude)}};
  const auto error = [&](double t, const auto& state) { return std::abs(state.values[0] - place(t)); };
  compare<Derivatives>("H15.spring", "place of a mass of 1 g at 1e9 N/m and 1e6 N s/m", "m", model, start, error,
                       figures);
  // The damper ties the speed to the place: what is an error of the one is k/c times as large in the other.
  const Run naive = by_plain_cvode<Derivatives>(model, start), ours = by_bdf<Derivatives>(model, start, error);
  figures.push_back({"H15.spring.steps",
                     "steps of BDF in 10 s",
                     "1",
                     static_cast<double>(naive.steps),
                     static_cast<double>(ours.steps),
                     3000,
                     naive.seconds,
                     ours.seconds,
                     "naive: CVODE with 1e-9, relative and absolute, for place and speed",
                     {}});
}

/// Of the acceleration of the spring by place and speed; `derivative(column)` is one form of it.
template <class Derivative>
double largest_error(const double (&exact)[2], Derivative&& derivative) {
  double largest = 0;
  for (int i = 0; i < 2; ++i) largest = std::max(largest, std::abs(derivative(i) / exact[i] - 1));
  return largest;
}

Figure jacobian() {
  namespace emitted = gauss::stiff_spring;
  using Dual = gauss::Dual<double, 2>;
  const double t = 0.3;
  const emitted::State<double> state{{0.7, -0.4}};
  const emitted::Parameters<double> parameters;
  const auto prepared = prepare(parameters);

  const auto dual_prepared = prepare(emitted::Parameters<Dual>{});
  emitted::Derivative<Dual> rates;
  rhs(Dual(t), emitted::State<Dual>{{Dual::variable(0.7, 0), Dual::variable(-0.4, 1)}}, emitted::Inputs<Dual>{},
      dual_prepared, rates);
  const double exact[2] = {rates.values[1].tangent[0], rates.values[1].tangent[1]};

  Figure figure{"H15.jacobian", "relative error of derivatives, against those along with values", "1", {}};
  figure.bar = 1e-12;
  emitted::Jacobian<double> entries;
  using Pattern = emitted::JacobianByState;
  if (jacobian(t, state, emitted::Inputs<double>{}, prepared, entries) != gauss::Status::ok) return figure;
  double dense_entries[Pattern::rows * Pattern::columns];
  dense(entries, Pattern{}, dense_entries);
  figure.ours = largest_error(exact, [&](int i) { return dense_entries[Pattern::columns + i]; });
  figure.naive = largest_error(exact, [&](int i) {
    const double step = 1e-8;
    emitted::State<double> shifted = state;
    shifted.values[i] += step;
    emitted::Derivative<double> here, there;
    rhs(t, state, emitted::Inputs<double>{}, prepared, here);
    rhs(t, shifted, emitted::Inputs<double>{}, prepared, there);
    return (there.values[1] - here.values[1]) / step;
  });
  figure.remark = "naive: differences";
  return figure;
}

}  // namespace

std::vector<Figure> stiff(const Scope&) {
  std::vector<Figure> figures;
  relaxation(figures);
  spring(figures);
  figures.push_back(jacobian());
  return figures;
}

}  // namespace hard_cases
