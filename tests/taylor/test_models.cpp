// Every model: its series satisfies its equations of motion, which rhs has from elsewhere, at times within the step.

#include <algorithm>
#include <cmath>
#include <memory>

#include "catch_shim.hpp"
#include "gauss/integrate/taylor.hpp"
#include "headers_with_series.inc"

namespace {

constexpr int k_order = 20;

template <class Values>
double largest(const Values& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

/// Where the last terms are rounding of the state. There may be one in each fourth order only.
template <class Series>
double span_of(const Series& series) {
  double span = 0.5;
  for (int k = k_order; k > k_order - 4; --k) {
    const double last = largest(series.values[k]);
    if (last > 0) span = std::min(span, std::pow(1e-16 * largest(series.values[0]) / last, 1.0 / k));
  }
  return span;
}

/// How far the rates of a series are from those of rhs at the end of a step, of their size; the state is that at the end then.
template <class Series, class Inputs, class Derivative, class State, class Prepared>
double residual(double& t, State& state, const Prepared& prepared) {
  const auto series = std::make_unique<Series>();
  Derivative rates;
  REQUIRE(taylor(t, state, Inputs{}, prepared, k_order, *series) == gauss::Status::ok);
  REQUIRE(rhs(t, state, Inputs{}, prepared, rates) == gauss::Status::ok);
  for (std::size_t i = 0; i < sizeof(rates.values) / sizeof(double); ++i) {
    CHECK(series->values[0][i] == state.values[i]);
    CHECK(std::abs(series->values[1][i] - rates.values[i]) <= 1e-12 * (1 + largest(rates.values)));
  }
  const double h = span_of(*series);
  double along[sizeof(rates.values) / sizeof(double)];
  gauss::integrate::rate_of_series(*series, h, along);
  gauss::integrate::state_of_series(*series, h, state);
  t += h;
  REQUIRE(rhs(t, state, Inputs{}, prepared, rates) == gauss::Status::ok);
  const double size = largest(rates.values) + largest(state.values) / h;
  double worst = 0;
  for (std::size_t i = 0; i < sizeof(rates.values) / sizeof(double); ++i)
    worst = std::max(worst, std::abs(along[i] - rates.values[i]) / size);
  return worst;
}

}  // namespace

// At the start of the model, and at the end of a step from there, where nothing is 0 by chance.
#define GAUSS_WITH_SERIES(model)                                                       \
  TEST_CASE("the series of " #model " satisfies its equations of motion") {            \
    const auto prepared = gauss::model::prepare(gauss::model::Parameters<double>{});   \
    gauss::model::State<double> state;                                                 \
    gauss::model::initial_state(prepared, state);                                      \
    double t = 0;                                                                      \
    for (int step = 0; step < 3; ++step) {                                             \
      CHECK(residual<gauss::model::TaylorSeries<double>, gauss::model::Inputs<double>, \
                     gauss::model::Derivative<double>>(t, state, prepared) < 1e-12);   \
    }                                                                                  \
  }
#include "models_with_series.inc"
