// Steps of one order: closed forms, orders of convergence, digits of other types, lanes.

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "catch_shim.hpp"
#include "double_pendulum.hpp"
#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/taylor.hpp"
#include "gauss/simulate/taylor_simulation.hpp"
#include "kepler.hpp"
#if __has_include(<xsimd/xsimd.hpp>)
#include "gauss/batch/taylor_lanes.hpp"
#define GAUSS_TEST_LANES
#endif
#ifdef GAUSS_TEST_FLOAT128
#include "gauss/scalar/float128.hpp"
#endif

namespace {

GAUSS_MODEL(Kepler, gauss::kepler);
GAUSS_MODEL(Pendulum, gauss::double_pendulum);

template <class S>
using KeplerSeries = gauss::kepler::TaylorSeries<S>;

/// Of an ellipse with a = mu = 1: the state at time t, by Kepler's equation E - e sin E = t.
template <class S>
gauss::kepler::State<S> on_ellipse(const S& t, const S& e) {
  using gauss::Math;
  S E = t;
  for (int i = 0; i < 60; ++i) E = E - (E - e * Math<S>::sin(E) - t) / (S(1) - e * Math<S>::cos(E));
  const S root = Math<S>::sqrt(S(1) - e * e), cosine = Math<S>::cos(E), sine = Math<S>::sin(E);
  const S rate = S(1) / (S(1) - e * cosine);
  return {{cosine - e, root * sine, -sine * rate, root * cosine * rate}};
}

template <class S>
double distance(const gauss::kepler::State<S>& a, const gauss::kepler::State<S>& b) {
  S worst = S(0);
  for (int i = 0; i < 4; ++i) {
    const S off = a.values[i] - b.values[i], size = off < S(0) ? -off : off;
    worst = worst < size ? size : worst;
  }
  return static_cast<double>(worst);
}

/// Error at t = 1 of steps of one length, from half of an orbit with e = 1/2 on.
double error_of(int order, int steps) {
  gauss::kepler::Parameters<double> parameters;
  parameters.e = 0.5;
  const auto model = gauss::integrate::bind_model<Kepler>(parameters);
  gauss::integrate::Taylor<decltype(model), KeplerSeries<double>> stepper(order);
  auto state = on_ellipse(1.5, 0.5);
  for (int i = 0; i < steps; ++i) REQUIRE(stepper.step(model, 0.0, 1.0 / steps, state).is_taken());
  return distance(state, on_ellipse(2.5, 0.5));
}

}  // namespace

TEST_CASE("half the step divides the error by two to the order") {
  for (const int order : {2, 3, 4, 6, 8}) {
    INFO("order " << order);
    const int steps = order < 5 ? 64 : 16;
    const double found = std::log2(error_of(order, steps) / error_of(order, 2 * steps));
    CHECK(found > order - 0.3);
    CHECK(found < order + 0.6);
  }
}

TEST_CASE("a step that has no series leaves the state and tells") {
  const auto model = gauss::integrate::bind_model<Kepler>();
  gauss::integrate::Taylor<decltype(model), KeplerSeries<double>> stepper(8);
  gauss::kepler::State<double> state{{0, 0, 1, 0}};
  const auto result = stepper.step(model, 0.0, 0.1, state);
  CHECK(result.outcome == gauss::integrate::StepOutcome::model_failed);
  CHECK(result.status == gauss::Status::not_finite);
  CHECK(state.values[0] == 0);
}

TEST_CASE("the order for a tolerance grows with its digits and stays within the series") {
  CHECK(gauss::integrate::taylor_order(1e-3, 40) < gauss::integrate::taylor_order(1e-6, 40));
  CHECK(gauss::integrate::taylor_order(1e-300, 40) == 40);
  CHECK(gauss::integrate::taylor_order(10, 40) == 2);
}

#ifdef GAUSS_TEST_FLOAT128
TEST_CASE("an orbit of order 30 has thirty digits") {
  using Wide = __float128;
  gauss::kepler::Parameters<Wide> parameters;
  parameters.e = Wide(0.5);
  const auto model = gauss::integrate::bind_model<Kepler, Wide>(parameters);
  const auto stepper = std::make_unique<gauss::integrate::Taylor<decltype(model), KeplerSeries<Wide>>>(30);
  auto state = on_ellipse(Wide(0), Wide(0.5));
  const int steps = 128;
  for (int i = 0; i < steps; ++i) REQUIRE(stepper->step(model, Wide(0), Wide(2) / Wide(steps), state).is_taken());
  CHECK(distance(state, on_ellipse(Wide(2), Wide(0.5))) < 1e-30);
}
#endif

#ifdef GAUSS_TEST_LANES
TEST_CASE("a lane has the series of its state alone, within rounding") {
  using Batch = xsimd::batch<double>;
  namespace pendulum = gauss::double_pendulum;
  const auto wide = pendulum::prepare(pendulum::Parameters<Batch>{});
  const auto one = pendulum::prepare(pendulum::Parameters<double>{});
  pendulum::State<Batch> states;
  pendulum::State<double> of_lane[Batch::size];
  for (std::size_t lane = 0; lane < Batch::size; ++lane) {
    for (int i = 0; i < 4; ++i) of_lane[lane].values[i] = 0.3 + 0.7 * i - 0.45 * static_cast<double>(lane);
  }
  for (int i = 0; i < 4; ++i) {
    double lanes[Batch::size];
    for (std::size_t lane = 0; lane < Batch::size; ++lane) lanes[lane] = of_lane[lane].values[i];
    states.values[i] = Batch::load_unaligned(lanes);
  }
  const auto all = std::make_unique<pendulum::TaylorSeries<Batch>>();
  const auto single = std::make_unique<pendulum::TaylorSeries<double>>();
  CHECK(!pendulum::taylor(Batch(0.0), states, pendulum::Inputs<Batch>{}, wide, 24, *all).any());
  for (std::size_t lane = 0; lane < Batch::size; ++lane) {
    pendulum::taylor(0.0, of_lane[lane], pendulum::Inputs<double>{}, one, 24, *single);
    for (int k = 0; k <= 24; ++k) {
      double size = 0;
      for (const double value : single->values[k]) size = std::max(size, std::abs(value));
      for (int i = 0; i < 4; ++i) CHECK(std::abs(all->values[k][i].get(lane) - single->values[k][i]) <= 1e-13 * size);
    }
  }
}
#endif

#ifdef GAUSS_TEST_LANES
TEST_CASE("lanes with steps of their own arrive where each of them does alone") {
  using Batch = xsimd::batch<double>;
  gauss::kepler::Parameters<Batch> parameters;
  double e[Batch::size];
  for (std::size_t lane = 0; lane < Batch::size; ++lane) e[lane] = 0.2 + 0.7 * static_cast<double>(lane) / Batch::size;
  parameters.e = Batch::load_unaligned(e);
  const auto model = gauss::integrate::bind_model<Kepler, Batch>(parameters);
  gauss::kepler::State<Batch> start;
  initial_state(model.prepared(), start);
  const auto lanes =
      std::make_unique<gauss::batch::TaylorLanes<std::decay_t<decltype(model)>, KeplerSeries<Batch>>>(model, start);
  REQUIRE(lanes->advance_to(3.0));
  REQUIRE(lanes->advance_to(8.0));
  for (std::size_t lane = 0; lane < Batch::size; ++lane) {
    INFO("e = " << e[lane]);
    const auto known = on_ellipse(8.0, e[lane]);
    for (int i = 0; i < 4; ++i) CHECK(std::abs(lanes->states().values[i].get(lane) - known.values[i]) < 1e-10);
    CHECK(lanes->times().get(lane) == 8.0);
  }
}

TEST_CASE("a lane that begins anew goes as it does from the beginning, and others do not notice") {
  using Batch = xsimd::batch<double>;
  gauss::kepler::Parameters<Batch> parameters, others;
  double e[Batch::size], other[Batch::size], marks[Batch::size] = {};
  for (std::size_t lane = 0; lane < Batch::size; ++lane)
    other[lane] = e[lane] = 0.2 + 0.7 * static_cast<double>(lane) / Batch::size;
  other[1] = 0.85;
  marks[1] = 1;
  parameters.e = Batch::load_unaligned(e);
  others.e = Batch::load_unaligned(other);
  const auto model = gauss::integrate::bind_model<Kepler, Batch>(parameters);
  const auto before = gauss::integrate::bind_model<Kepler, Batch>(others);
  gauss::kepler::State<Batch> start, start_before;
  initial_state(model.prepared(), start);
  initial_state(before.prepared(), start_before);
  using Lanes = gauss::batch::TaylorLanes<std::decay_t<decltype(model)>, KeplerSeries<Batch>>;
  const auto fresh = std::make_unique<Lanes>(model, start), mended = std::make_unique<Lanes>(before, start_before);
  REQUIRE(fresh->advance_to(8.0));
  for (int step = 0; step < 7; ++step) mended->step_towards(8.0);
  REQUIRE(xsimd::none(mended->are_done(8.0)));
  mended->begin(Batch::load_unaligned(marks) > Batch(0.5), model, start, Batch(0.0));
  REQUIRE(mended->advance_to(8.0));
  for (std::size_t lane = 0; lane < Batch::size; ++lane) {
    INFO("lane " << lane);
    for (int i = 0; i < 4; ++i) CHECK(mended->states().values[i].get(lane) == fresh->states().values[i].get(lane));
    CHECK(mended->steps_of_lanes().get(lane) == fresh->steps_of_lanes().get(lane));
  }
}

TEST_CASE("a lane that is lost stops and the others arrive") {
  using Batch = xsimd::batch<double>;
  const auto model = gauss::integrate::bind_model<Kepler, Batch>();
  gauss::kepler::State<Batch> start;
  initial_state(model.prepared(), start);
  double x[Batch::size], y[Batch::size];
  start.values[0].store_unaligned(x);
  start.values[3].store_unaligned(y);
  x[1] = 1;  // it falls into the sun
  y[1] = 0;
  start.values[0] = Batch::load_unaligned(x);
  start.values[3] = Batch::load_unaligned(y);
  const auto lanes =
      std::make_unique<gauss::batch::TaylorLanes<std::decay_t<decltype(model)>, KeplerSeries<Batch>>>(model, start);
  CHECK_FALSE(lanes->advance_to(4.0));
  for (std::size_t lane = 0; lane < Batch::size; ++lane) CHECK(lanes->lost().get(lane) == (lane == 1));
  const auto known = on_ellipse(4.0, 0.9);
  CHECK(std::abs(lanes->states().values[0].get(0) - known.values[0]) < 1e-9);
}

/// Five digits, in every lane; what is no number stays none.
template <class T>
void check_rough_powers() {
  using Batch = xsimd::batch<T>;
  const auto lanes_of = [](const Batch& x) {
    std::array<T, Batch::size> lanes;
    x.store_unaligned(lanes.data());
    return lanes;
  };
  const double largest = sizeof(T) == 8 ? 990 : 118;
  for (double y = -largest; y < largest; y += 0.0173 * largest / 100) {
    const T x = static_cast<T>(std::exp2(y));
    for (const T log2 : lanes_of(gauss::batch::rough_log2(Batch(x)))) CHECK(std::abs(log2 - std::log2(x)) < 5e-5);
    const T exact = std::exp2(static_cast<T>(y));
    for (const T power : lanes_of(gauss::batch::rough_exp2(Batch(static_cast<T>(y)))))
      CHECK(std::abs(power - exact) < T(5e-6) * exact);
  }
  const Batch none(std::numeric_limits<T>::quiet_NaN());
  CHECK(xsimd::all(xsimd::isnan(gauss::batch::rough_log2(none))));
  CHECK(xsimd::all(xsimd::isnan(gauss::batch::rough_exp2(none))));
  CHECK(lanes_of(gauss::batch::rough_exp2(Batch(T(-2000))))[0] > T(0));
}

TEST_CASE("rough logarithms and powers of lanes have five digits") {
  check_rough_powers<double>();
  check_rough_powers<float>();
}

TEST_CASE("lanes that start at rest have a first step, and samples see the motion within steps") {
  using Batch = xsimd::batch<double>;
  namespace pendulum = gauss::double_pendulum;
  const auto model = gauss::integrate::bind_model<Pendulum, Batch>();
  pendulum::State<Batch> start;
  initial_state(model.prepared(), start);
  using Lanes = gauss::batch::TaylorLanes<std::decay_t<decltype(model)>, pendulum::TaylorSeries<Batch>>;
  const auto lanes = std::make_unique<Lanes>(model, start, Batch(0.0), gauss::simulate::Settings<double>{});
  REQUIRE(xsimd::none(lanes->are_done(2.0)));
  lanes->step_towards(2.0);
  const double first = lanes->times().get(0);
  CHECK(first > 1e-3);
  CHECK(lanes->begin_of_step().get(0) == 0);
  CHECK(lanes->steps_of_lanes().get(0) == 1);
  pendulum::State<Batch> middle;
  gauss::integrate::state_of_series(lanes->series(), Batch(first / 2), middle);
  REQUIRE(lanes->advance_to(2.0));
  const auto alone = gauss::integrate::bind_model<Pendulum, double>();
  pendulum::State<double> begin;
  initial_state(alone.prepared(), begin);
  using Single = gauss::simulate::TaylorSimulation<std::decay_t<decltype(alone)>, pendulum::TaylorSeries<double>>;
  const auto single = std::make_unique<Single>(alone, begin);
  const auto stepping = std::make_unique<Single>(alone, begin);
  REQUIRE(stepping->advance_to(first * (1 - 1e-4)));
  CHECK(stepping->report().steps == 1);
  REQUIRE(stepping->advance_to(first * (1 + 1e-4)));
  CHECK(stepping->report().steps == 2);
  REQUIRE(single->advance_to(first / 2));
  for (int i = 0; i < 4; ++i) CHECK(std::abs(middle.values[i].get(0) - single->state().values[i]) < 1e-11);
  REQUIRE(single->advance_to(2.0));
  for (int i = 0; i < 4; ++i) CHECK(std::abs(lanes->states().values[i].get(0) - single->state().values[i]) < 1e-9);
  CHECK(std::abs(lanes->steps_of_lanes().get(0) - static_cast<double>(single->report().steps)) <= 3);
}
#endif
