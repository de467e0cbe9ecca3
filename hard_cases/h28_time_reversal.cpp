// 100 s out and back: what symmetric methods give back of motions that are regular, that begin to be chaotic and that are; and whether emitted
// accelerations know the direction of time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "double_pendulum.hpp"
#include "elastic_pendulum.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#include "gauss/integrate/gauss_legendre.hpp"
#include "gauss/integrate/nystrom_stepper.hpp"
#include "gauss/integrate/reversible_verlet.hpp"
#include "gauss/simulate/fixed_step.hpp"
#include "registry.hpp"

namespace hard_cases {

GAUSS_MODEL(DoublePendulum, gauss::double_pendulum);
GAUSS_MODEL(ElasticPendulum, gauss::elastic_pendulum);

namespace {

constexpr std::int64_t k_steps = 10'000;
constexpr double k_step = 0.01;  // s

template <class State>
double difference(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t i = 0; i < std::size(a.values); ++i) grow(largest, static_cast<double>(a.values[i] - b.values[i]));
  return largest;
}

struct Way {
  double lost = k_breaks_down;  ///< between the start and what comes back, largest component
  double seconds = 0;
};

template <class Stepper, class Model>
Way out_and_back(const Model& model, const typename Model::State& start) {
  Way result;
  const Stopwatch stopwatch;
  gauss::simulate::FixedStep<Model, Stepper> run(model, start, k_step);
  bool arrives = run.advance(k_steps);
  run.turn_back();
  arrives = arrives && run.advance(k_steps);
  if (arrives) result.lost = difference(run.state(), start);
  result.seconds = stopwatch.seconds();
  return result;
}

/// How far a start that is 1e-9 aside is from this one, after the first and the second half of the way.
template <class Stepper, class Model>
std::string neighbours(const Model& model, const typename Model::State& start) {
  typename Model::State beside = start;
  beside.values[0] += static_cast<typename Model::Scalar>(1e-9);
  gauss::simulate::FixedStep<Model, Stepper> one(model, start, k_step), other(model, beside, k_step);
  double apart[2] = {k_breaks_down, k_breaks_down};
  for (double& now : apart)
    if (one.advance(k_steps / 2) && other.advance(k_steps / 2)) now = difference(one.state(), other.state());
  char text[80];
  std::snprintf(text, sizeof text, "1e-9 beside the start is %.1g after 50 s, %.1g after 100 s", apart[0], apart[1]);
  return text;
}

template <class Naive, class Ours, class Model>
Figure reversal(const char* id, const char* quantity, const char* unit, const Model& model,
                const typename Model::State& start) {
  const Way naive = out_and_back<Naive>(model, start), ours = out_and_back<Ours>(model, start);
  return {
      id, quantity, unit, naive.lost, ours.lost, 1e-12, naive.seconds, ours.seconds, neighbours<Ours>(model, start)};
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

/// Accelerations of angles depend on speeds, so steps are implicit, and equal but for rounding on the way back. The motion enlarges that as it does
/// the distance of neighbours: 2e-10 are lost in double.
Figure beginning_chaos() {
  const auto model = gauss::integrate::bind_model<DoublePendulum, long double>();
  using Model = std::decay_t<decltype(model)>;
  return reversal<gauss::integrate::Rk4<Model>, gauss::integrate::GaussLegendre<Model, 3>>(
      "H28.double", "the same from where it begins to be chaotic, in long double", "rad, rad/s", model,
      {{0.7L, 0.8L, 0, 0}});
}

/// Neighbours are as far apart as the motion is wide after 75 s: a symmetric method that rounds loses all.
Figure chaos() {
  const auto model = gauss::integrate::bind_model<ElasticPendulum>();
  using Model = std::decay_t<decltype(model)>;
  return reversal<gauss::integrate::Verlet<Model>, gauss::integrate::ReversibleVerlet<Model>>(
      "H28.chaos", "bob on a soft spring, 100 s out and back, naive Verlet's steps as usual", "m, m/s", model,
      {{0.5, 0, 0, 0}});
}

}  // namespace

std::vector<Figure> time_reversal(const Scope&) {
  const auto model = gauss::integrate::bind_model<DoublePendulum>();
  using Model = std::decay_t<decltype(model)>;
  Figure bits{"H28.bits", "states of 1000 where a(q, -v) differs from a(q, v)", "1", {}};
  bits.ours = direction_of_time(model);
  return {reversal<gauss::integrate::Rk4<Model>, gauss::integrate::GaussLegendre<Model, 3>>(
              "H28.state", "component of a double pendulum after 100 s out and back, naive RK4", "rad, rad/s", model,
              {{0.6, -0.4, 0, 0}}),
          beginning_chaos(), chaos(), bits};
}

}  // namespace hard_cases
