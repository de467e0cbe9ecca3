// 100 s out and back: what a symmetric method gives back, and whether emitted accelerations know the direction of time.

#include <algorithm>
#include <cmath>

#include "double_pendulum.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(DoublePendulum, gauss::double_pendulum);

namespace {

/// Largest difference of a component, rad or rad/s, between the start and what comes back.
template <class Stepper, class Model>
double lost(const Model& model, const typename Model::State& start) {
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, 0.01);
  if (!run.advance(10'000)) return k_breaks_down;
  run.turn_back();
  if (!run.advance(10'000)) return k_breaks_down;
  double largest = 0;
  for (std::size_t i = 0; i < Model::size; ++i)
    largest = std::max(largest, std::abs(run.state().values[i] - start.values[i]));
  return largest;
}

/// Number of states, of 1000, at which an acceleration has another bit when all speeds change their sign.
template <class Model>
double direction_of_time(const Model& model) {
  int different = 0;
  for (int k = 0; k < 1000; ++k) {
    typename Model::State there{{0.37 * k, std::sin(1.7 * k), 3 * std::cos(0.9 * k), 5 * std::sin(2.3 * k + 1)}};
    typename Model::State back = there;
    for (std::size_t i = Model::n_q; i < Model::size; ++i) back.values[i] = -back.values[i];
    typename Model::Derivative a, b;
    if (model.derivative(0.0, there, a) != gauss::Status::ok) return k_breaks_down;
    if (model.derivative(0.0, back, b) != gauss::Status::ok) return k_breaks_down;
    if (!std::equal(a.values + Model::n_q, a.values + Model::size, b.values + Model::n_q)) ++different;
  }
  return different;
}

}  // namespace

std::vector<Figure> time_reversal(const Scope&) {
  const auto prepared = DoublePendulum::prepare(gauss::double_pendulum::Parameters<double>{});
  const auto model = gauss::integrate::bind_model<DoublePendulum>(prepared, gauss::double_pendulum::Inputs<double>{});
  using Model = std::decay_t<decltype(model)>;
  const gauss::double_pendulum::State<double> start{{0.6, -0.4, 0, 0}};
  Figure figure{"H28.state", "component after 100 s out and back", "rad, rad/s", {}};
  figure.bar = 1e-12;
  Stopwatch naive;
  figure.naive = lost<gauss::integrate::Rk4<Model>>(model, start);
  figure.seconds_naive = naive.seconds();
  Stopwatch ours;
  figure.ours = lost<gauss::integrate::GaussLegendre<Model, 3>>(model, start);
  figure.seconds_ours = ours.seconds();
  Figure bits{"H28.bits", "states of 1000 where a(q, -v) differs from a(q, v)", "1", {}};
  bits.ours = direction_of_time(model);
  return {figure, bits};
}

}  // namespace hard_cases
