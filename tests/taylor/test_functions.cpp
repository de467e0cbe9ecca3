// Coefficients of every function that has a series, against Cauchy's integral over a circle of complex times: f_k = mean of f(t + r e^(i a)) r^-k e^(-i k a).

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>

#include "all_functions.hpp"
#include "catch_shim.hpp"

namespace {

namespace model = gauss::all_functions;
using Complex = std::complex<long double>;

constexpr int k_order = 30;
constexpr long double k_radius = 1.5L;

struct Named {
  const char* name;
  std::function<Complex(Complex x, Complex t)> value;
};

Complex angle_of(Complex y, Complex x) { return std::atan(y / x); }

/// In the order of the coordinates, without x.
const std::array<Named, 24>& functions() {
  static const std::array<Named, 24> k_functions{
      {{"sine", [](Complex x, Complex) { return std::sin(x); }},
       {"cosine", [](Complex x, Complex) { return std::cos(2.0L * x); }},
       {"tangent", [](Complex x, Complex) { return std::tan(x); }},
       {"arc_sine", [](Complex x, Complex) { return std::asin(x / 2.0L); }},
       {"arc_cosine", [](Complex x, Complex) { return std::acos(x / 3.0L); }},
       {"arc_tangent", [](Complex x, Complex) { return std::atan(x); }},
       {"angle", [](Complex x, Complex) { return angle_of(x, 2.0L - x); }},
       {"exponential", [](Complex x, Complex) { return std::exp(-x); }},
       {"logarithm", [](Complex x, Complex) { return std::log(x + 1.0L); }},
       {"hyperbolic_sine", [](Complex x, Complex) { return std::sinh(x); }},
       {"hyperbolic_cosine", [](Complex x, Complex) { return std::cosh(x / 2.0L); }},
       {"hyperbolic_tangent", [](Complex x, Complex) { return std::tanh(x); }},
       {"root", [](Complex x, Complex) { return std::sqrt(1.0L + x * x); }},
       {"root_of_cube", [](Complex x, Complex) { return std::pow(1.0L + x, 1.5L); }},
       {"broken_power", [](Complex x, Complex) { return std::exp(std::log(2.0L + x) * 5.0L / 7.0L); }},
       {"inverse_cube", [](Complex x, Complex) { return 1.0L / ((1.0L + x * x) * (1.0L + x * x) * (1.0L + x * x)); }},
       {"inverse_root", [](Complex x, Complex) { return 1.0L / std::sqrt(3.0L + x); }},
       {"seventh", [](Complex x, Complex) { return x * x * x * x * x * x * x; }},
       {"reciprocal", [](Complex x, Complex) { return 1.0L / (1.0L + x); }},
       {"quotient", [](Complex x, Complex) { return std::sin(x) / (2.0L + std::cos(x)); }},
       {"product", [](Complex x, Complex) { return x * std::exp(x) * std::sin(x); }},
       {"squared_sum", [](Complex x, Complex) { return (std::sin(x) + x) * (std::sin(x) + x); }},
       {"timed", [](Complex, Complex t) { return t * t * std::sin(t) - t; }},
       {"driven", [](Complex x, Complex) { return 1.5L * x * x; }}}};
  return k_functions;
}

std::array<long double, k_order> coefficients(const Named& function, long double t0) {
  constexpr int k_points = 256;
  std::array<long double, k_order> result{};
  for (int i = 0; i < k_points; ++i) {
    const long double a = 2 * std::acos(-1.0L) * i / k_points;
    const Complex step = std::polar(k_radius, a), t = t0 + step;
    const Complex value = function.value(0.7L + 0.3L * step, t);
    for (int k = 0; k < k_order; ++k)
      result[static_cast<std::size_t>(k)] += (value * std::polar(std::pow(k_radius, -k), -a * k)).real() / k_points;
  }
  return result;
}

template <class S>
double worst_of(const Named& function, std::size_t place, const model::TaylorSeries<S>& series, double t0) {
  const auto known = coefficients(function, t0);
  long double size = 0, worst = 0;
  for (int k = 0; k < k_order; ++k) {
    const long double weight = std::pow(k_radius, k), exact = known[static_cast<std::size_t>(k)];
    const auto found =
        static_cast<long double>(series.values[k + 1][model::n_q + static_cast<int>(place) + 1]) * (k + 1);
    size = std::max(size, std::abs(exact) * weight);
    worst = std::max(worst, std::abs(found - exact) * weight);
  }
  return static_cast<double>(worst / size);
}

template <class S>
void check_all(double allowed) {
  const auto prepared = model::prepare(model::Parameters<S>{});
  model::State<S> state;
  model::initial_state(prepared, state);
  const auto series = std::make_unique<model::TaylorSeries<S>>();
  const double t0 = 0.5;
  REQUIRE(model::taylor(S(t0), state, model::Inputs<S>{}, prepared, k_order, *series) == gauss::Status::ok);
  CHECK(series->order == k_order);
  for (std::size_t i = 0; i < functions().size(); ++i) {
    INFO(functions()[i].name);
    CHECK(worst_of(functions()[i], i, *series, t0) < allowed);
  }
}

}  // namespace

TEST_CASE("every function has the coefficients of Cauchy's integral") {
  check_all<double>(2e-14);
  check_all<float>(1e-5);
  check_all<long double>(1e-16);
}

TEST_CASE("an order out of range is the nearest one within") {
  const auto prepared = model::prepare(model::Parameters<double>{});
  model::State<double> state;
  model::initial_state(prepared, state);
  const auto series = std::make_unique<model::TaylorSeries<double>>();
  model::taylor(0.0, state, model::Inputs<double>{}, prepared, 1000, *series);
  CHECK(series->order == model::TaylorSeries<double>::most);
  model::taylor(0.0, state, model::Inputs<double>{}, prepared, -1, *series);
  CHECK(series->order == 1);
}

TEST_CASE("what is no number has a status") {
  const auto prepared = model::prepare(model::Parameters<double>{});
  model::State<double> state;
  model::initial_state(prepared, state);
  state.sine() = std::nan("");
  const auto series = std::make_unique<model::TaylorSeries<double>>();
  CHECK(model::taylor(0.0, state, model::Inputs<double>{}, prepared, 8, *series) == gauss::Status::not_finite);
}
