// The driver of batches: what it computes for many trajectories is what emitted code computes for each of them.

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "four_bar.hpp"
#include "functions.hpp"
#include "gauss/batch/evaluator.hpp"
#include "rotor_on_platform.hpp"
#include "sphere_in_cylinder.hpp"
#include "sphere_in_cylinder_quaternion.hpp"

GAUSS_MODEL(Ball, gauss::sphere_in_cylinder);
GAUSS_MODEL(BallByQuaternion, gauss::sphere_in_cylinder_quaternion);
GAUSS_MODEL(Linkage, gauss::four_bar);
GAUSS_MODEL(Rotor, gauss::rotor_on_platform);
GAUSS_MODEL(Functions, gauss::functions);

namespace {

using gauss::Status;
using gauss::batch::Columns;
using gauss::batch::Evaluator;
using gauss::batch::Points;

constexpr std::size_t k_most = 37;    // no multiple of any number of lanes
constexpr std::size_t k_stride = 41;  // and the arrays are longer than needed
constexpr double k_untouched = 12345;
/// Of the largest value: xsimd's functions differ from the C library's in the last digit, and the linear systems of these
/// states have conditions up to some hundred.
constexpr double k_tolerance = 1e-12;

/// Trajectories of a model near its initial state, satisfying the constraints, in columns.
template <class M>
struct Trajectories {
  static constexpr int n = M::n_q + M::n_v;

  std::vector<double> states = std::vector<double>(n * k_stride, 0.0);
  std::vector<double> inputs = std::vector<double>((M::n_inputs + 1) * k_stride, 0.0);
  std::vector<double> times = std::vector<double>(k_stride, 0.0);

  explicit Trajectories(std::size_t count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto prepared = M::prepare(typename M::template Parameters<double>{});
    for (std::size_t k = 0; k < count; ++k) {
      times[k] = 0.5 + 0.01 * any(random);
      for (int i = 0; i < M::n_inputs; ++i) inputs[at(i, k)] = any(random);
      typename M::template State<double> state{};
      REQUIRE(initial_state(prepared, state) == Status::ok);
      for (double& value : state.values) value += 0.02 * any(random);
      (void)project(times[k], state, prepared, state);
      for (int i = 0; i < n; ++i) states[at(i, k)] = state.values[i];
    }
  }

  static std::size_t at(int component, std::size_t k) { return static_cast<std::size_t>(component) * k_stride + k; }

  Points<double> points(std::size_t first, std::size_t count) const {
    Points<double> result;
    result.count = count;
    result.states = {states.data() + first, k_stride};
    result.times = times.data() + first;
    result.inputs = {inputs.data() + first, k_stride};
    return result;
  }

  typename M::template State<double> state(std::size_t k) const {
    typename M::template State<double> result;
    for (int i = 0; i < n; ++i) result.values[i] = states[at(i, k)];
    return result;
  }
  typename M::template Inputs<double> inputs_of(std::size_t k) const {
    typename M::template Inputs<double> result;
    for (int i = 0; i < M::n_inputs; ++i) result.*M::template inputs_of<double>()[i] = inputs[at(i, k)];
    return result;
  }
};

struct Found {
  std::vector<double> values;
  std::vector<Status> statuses = std::vector<Status>(k_most + 1, Status::violated_constraints);
  std::size_t bad = 0;
};

template <class M, class S>
Found rates(const Evaluator<M, double, S>& evaluator, const Points<double>& points) {
  Found found;
  found.values.assign(static_cast<std::size_t>(M::n_q + M::n_v) * k_stride, k_untouched);
  found.bad = evaluator.rhs(points, {found.values.data(), k_stride}, found.statuses.data());
  return found;
}

template <class M>
void agrees_with_one_at_a_time() {
  INFO(M::name);
  const Trajectories<M> all(k_most);
  const auto prepared = M::prepare(typename M::template Parameters<double>{});
  const Evaluator<M> evaluator;
  for (std::size_t count = 1; count <= k_most; count += 4) {
    const Found found = rates(evaluator, all.points(0, count));
    CHECK(found.bad == 0);
    for (std::size_t k = 0; k < count; ++k) {
      typename M::template Derivative<double> expected;
      CHECK(found.statuses[k] == M::rhs(all.times[k], all.state(k), all.inputs_of(k), prepared, expected));
      double size = 0, worst = 0;
      for (int i = 0; i < all.n; ++i) {
        size = std::max(size, std::fabs(expected.values[i]));
        worst = std::max(worst, std::fabs(expected.values[i] - found.values[all.at(i, k)]));
      }
      CHECK(worst <= k_tolerance * size);
    }
    // What lies behind the trajectories is not ours.
    for (int i = 0; i < all.n; ++i) CHECK(found.values[all.at(i, count)] == k_untouched);
    CHECK(found.statuses[count] == Status::violated_constraints);
  }
}

template <class M>
void is_independent_of_its_place() {
  INFO(M::name);
  const Trajectories<M> all(k_most);
  const Evaluator<M> evaluator;
  const Found together = rates(evaluator, all.points(0, k_most));
  for (std::size_t k = 0; k < k_most; ++k) {
    const Found alone = rates(evaluator, all.points(k, 1));
    for (int i = 0; i < all.n; ++i) CHECK(together.values[all.at(i, k)] == alone.values[all.at(i, 0)]);
  }
}

template <class M>
void one_bad_one_hurts_no_other() {
  INFO(M::name);
  Trajectories<M> all(k_most);
  const Evaluator<M> evaluator;
  const Found before = rates(evaluator, all.points(0, k_most));
  constexpr std::size_t k_bad = 6;
  all.states[all.at(0, k_bad)] = std::nan("");
  const Found after = rates(evaluator, all.points(0, k_most));
  CHECK(after.bad == 1);
  for (std::size_t k = 0; k < k_most; ++k) {
    CHECK(after.statuses[k] == (k == k_bad ? Status::not_finite : Status::ok));
    for (int i = 0; i < all.n && k != k_bad; ++i) CHECK(after.values[all.at(i, k)] == before.values[all.at(i, k)]);
  }
}

}  // namespace

TEST_CASE("rates of many trajectories are those of each, for any number of them, and nothing else is written") {
  agrees_with_one_at_a_time<Ball>();
  agrees_with_one_at_a_time<BallByQuaternion>();
  agrees_with_one_at_a_time<Linkage>();
  agrees_with_one_at_a_time<Rotor>();
  agrees_with_one_at_a_time<Functions>();
}

TEST_CASE("a trajectory has the same bits wherever it stands, and however many others there are") {
  is_independent_of_its_place<Ball>();
  is_independent_of_its_place<BallByQuaternion>();
  is_independent_of_its_place<Linkage>();
  is_independent_of_its_place<Functions>();
}

TEST_CASE("a trajectory that fails is named, and changes no bit of the others") {
  one_bad_one_hurts_no_other<Ball>();
  one_bad_one_hurts_no_other<BallByQuaternion>();
  one_bad_one_hurts_no_other<Linkage>();
}

TEST_CASE("a quaternion that is not of unit length is a matter of its own trajectory") {
  Trajectories<BallByQuaternion> all(k_most);
  for (int i = 2; i < 6; ++i) all.states[all.at(i, 4)] *= 1.5;
  const Found found = rates(Evaluator<BallByQuaternion>{}, all.points(0, k_most));
  CHECK(found.bad == 1);
  CHECK(found.statuses[4] == Status::violated_constraints);
  CHECK(found.statuses[3] == Status::ok);
}

TEST_CASE("one number at a time, the driver is the emitted function bit for bit") {
  const Trajectories<Ball> all(k_most);
  const Evaluator<Ball, double, double> evaluator;
  static_assert(evaluator.lanes == 1);
  const Found found = rates(evaluator, all.points(0, k_most));
  const auto prepared = Ball::prepare(Ball::Parameters<double>{});
  for (std::size_t k = 0; k < k_most; ++k) {
    Ball::Derivative<double> expected;
    (void)Ball::rhs(all.times[k], all.state(k), {}, prepared, expected);
    for (int i = 0; i < all.n; ++i) CHECK(found.values[all.at(i, k)] == expected.values[i]);
  }
}

TEST_CASE("in float there are more of them at a time") {
  const Evaluator<Ball, float> evaluator;
  CHECK(evaluator.lanes >= Evaluator<Ball, double>::lanes);
  const Trajectories<Ball> all(k_most);
  const std::vector<float> states(all.states.begin(), all.states.end());
  std::vector<float> rates_of_all(states.size());
  Points<float> points;
  points.count = k_most;
  points.states = {states.data(), k_stride};
  CHECK(evaluator.rhs(points, {rates_of_all.data(), k_stride}) == 0);
  const Found in_double = rates(Evaluator<Ball>{}, all.points(0, k_most));
  for (std::size_t k = 0; k < k_most; ++k)
    CHECK(std::fabs(in_double.values[all.at(9, k)] - static_cast<double>(rates_of_all[all.at(9, k)])) < 1e-3);
}

TEST_CASE("reactions come with the rates, member after member of their struct") {
  const Trajectories<Ball> all(k_most);
  const auto prepared = Ball::prepare(Ball::Parameters<double>{});
  constexpr std::size_t k_scalars = sizeof(gauss::sphere_in_cylinder::Reactions<double>) / sizeof(double);
  std::vector<double> derivatives(10 * k_stride), reactions(k_scalars * k_stride);
  const Evaluator<Ball> evaluator;
  CHECK(evaluator.rhs_and_reactions<gauss::sphere_in_cylinder::Reactions>(
            all.points(0, k_most), {derivatives.data(), k_stride}, {reactions.data(), k_stride}) == 0);
  for (std::size_t k = 0; k < k_most; ++k) {
    Ball::Derivative<double> derivative;
    gauss::sphere_in_cylinder::Reactions<double> expected;
    (void)rhs_and_reactions(0.0, all.state(k), Ball::Inputs<double>{}, prepared, derivative, expected);
    CHECK(reactions[k] == Approx(expected.rolling_around.multiplier).margin(1e-12));
    CHECK(reactions[(k_scalars - 1) * k_stride + k] == Approx(expected.rho.generalized));
    CHECK(derivatives[8 * k_stride + k] == Approx(derivative.psi_ddot()));
  }
}

TEST_CASE("each trajectory may have parameters of its own") {
  const Trajectories<Ball> all(k_most);
  constexpr std::size_t k_parameters = Ball::n_parameters;
  std::vector<double> parameters(k_parameters * k_stride);
  const auto set_of = [](std::size_t k) {
    Ball::Parameters<double> one;
    one.r = 0.05 + 0.001 * static_cast<double>(k);
    one.g = 9 + 0.1 * static_cast<double>(k);
    return one;
  };
  for (std::size_t k = 0; k < k_most; ++k) {
    for (std::size_t i = 0; i < k_parameters; ++i)
      parameters[i * k_stride + k] = set_of(k).*Ball::parameters_of<double>()[i];
  }
  const Evaluator<Ball> evaluator(k_most, {parameters.data(), k_stride});
  const Found found = rates(evaluator, all.points(0, k_most));
  for (std::size_t k = 0; k < k_most; ++k) {
    Ball::Derivative<double> expected;
    (void)Ball::rhs(all.times[k], all.state(k), {}, Ball::prepare(set_of(k)), expected);
    for (int i = 5; i < 10; ++i) CHECK(found.values[all.at(i, k)] == Approx(expected.values[i]).margin(1e-10));
  }
}

TEST_CASE("inputs and time that all have in common are stated once") {
  const Trajectories<Rotor> all(k_most);
  Evaluator<Rotor> evaluator;
  for (int i = 0; i < Rotor::n_inputs; ++i) evaluator.inputs.*Rotor::inputs_of<double>()[i] = 0.25;
  Points<double> points = all.points(0, k_most);
  points.inputs = {};
  points.times = nullptr;
  points.time = 0.75;
  const Found found = rates(evaluator, points);
  for (std::size_t k = 0; k < k_most; ++k) {
    Rotor::Derivative<double> expected;
    (void)Rotor::rhs(0.75, all.state(k), evaluator.inputs, Rotor::prepare(Rotor::Parameters<double>{}), expected);
    for (int i = 0; i < all.n; ++i) CHECK(found.values[all.at(i, k)] == Approx(expected.values[i]).margin(1e-10));
  }
}
