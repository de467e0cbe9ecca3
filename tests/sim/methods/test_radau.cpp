// Collocation at Radau's points: its coefficients, and what is stiff.

#include <algorithm>
#include <limits>

#include "gauss/integrate/radau.hpp"
#include "orders.hpp"

using namespace orders;
using gauss::integrate::RadauTableau;

namespace {

/// Slip of a block of 1 kg that a force begins to move from rest: s'' = (1, 2)/sqrt(5) t - s'/|s'|, of which s' = (1, 2)/sqrt(5) (t^2 - 1)/2 - (t - 1) is a solution from t = 1
/// on. Directions near it come to it with 1/|s'| per second, 1e12 at first.
template <class S>
struct SlipBegins {
  static int rates(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S u = a.y[2], v = a.y[3], size = std::sqrt(u * u + v * v), part = a.t / std::sqrt(S(5));
    const S result[] = {u, v, part - u / size, 2 * part - v / size};
    std::copy(result, result + 4, a.result);
    return 0;
  }
  static int jacobian(const void*, void* const* all) {
    const Arguments<S> a(all);
    const S u = a.y[2], v = a.y[3], cube = std::pow(u * u + v * v, S(1.5));
    std::fill(a.result, a.result + 16, S(0));
    a.result[2] = a.result[7] = 1;
    a.result[10] = -v * v / cube;
    a.result[11] = a.result[14] = u * v / cube;
    a.result[15] = -u * u / cube;
    return 0;
  }
  static std::shared_ptr<problems::Functions<S>> functions() {
    auto result = std::make_shared<problems::Functions<S>>();
    result->n_q = result->n_v = 2;
    result->units = {"m", "m", "m/s", "m/s"};
    result->rates = problems::bound<S>(rates);
    result->jacobian = problems::bound<S>(jacobian);
    result->jacobian_layout = problems::full_layout(4);
    return result;
  }
  /// `t` from the begin.
  static gausssim::Numbers<S> at(S t) {
    const S way = t * t * t / 6, speed = t * t / 2, root = std::sqrt(S(5));
    return {way / root, 2 * way / root, speed / root, 2 * speed / root};
  }

 private:
  template <class T>
  using Arguments = problems::Arguments<T>;
};

template <class S>
S worst_condition(int most_quadrature, int most_stage) {
  const RadauTableau<S> tableau;
  constexpr std::size_t n = RadauTableau<S>::stages;
  S worst = 0;
  // The inverse of A maps c^k/k to c^(k-1).
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 1; k <= most_stage; ++k) {
      S sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += tableau.inverse[i][j] * std::pow(tableau.c[j], S(k)) / S(k);
      worst = std::max(worst, std::abs(sum - std::pow(tableau.c[i], S(k - 1))));
    }
  // Weights by moments of degree 0 to 4; those of 5 to 8 are what Radau's points bring.
  gauss::integrate::DenseLu<S> moments;
  moments.begin(n);
  std::vector<S> right(n), weights;
  for (std::size_t k = 0; k < n; ++k) {
    right[k] = 1 / S(k + 1);
    for (std::size_t j = 0; j < n; ++j) moments.at(k, j) = std::pow(tableau.c[j], S(k));
  }
  REQUIRE(moments.factorise());
  moments.solve(right, weights);
  for (int k = 1; k <= most_quadrature; ++k) {
    S sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += weights[j] * std::pow(tableau.c[j], S(k - 1));
    worst = std::max(worst, std::abs(sum - 1 / S(k)));
  }
  return worst;
}

}  // namespace

TEST_CASE("its points make a quadrature of order 9, and stages of order 5") {
  CHECK(worst_condition<double>(9, 5) < 1e-13);
  CHECK(worst_condition<long double>(9, 5) < 1e-16L);
  CHECK(worst_condition<double>(10, 5) > 1e-6);
  CHECK(worst_condition<double>(9, 6) > 1e-6);
}

TEST_CASE("what decays in a billionth of a second takes no steps of its own") {
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    MethodSettings<double> settings;
    settings.projection = Projection::off;
    settings.tolerance = tolerance;
    std::string why;
    const MotionModel<double> model(problems::Pulled<double>::functions());
    const auto integrator = make_integrator("radau", model, problems::Pulled<double>::at(0), 0.0, settings, why);
    REQUIRE(integrator != nullptr);
    REQUIRE(integrator->advance_to(20.0));
    CAPTURE(tolerance);
    // The speed is k/c = 1000/s times what the place is behind.
    CHECK(std::abs(integrator->state()[0] - problems::Pulled<double>::at(20)[0]) < 2 * tolerance);
    CHECK(std::abs(integrator->state()[1] - problems::Pulled<double>::at(20)[1]) < 2000 * tolerance);
    CHECK(integrator->progress().steps < 200);
    CHECK(integrator->progress().rejected < integrator->progress().steps);
    CHECK(integrator->progress().jacobians > 0);
  }
}

TEST_CASE("in long double it has the digits of long double") {
  MethodSettings<long double> settings;
  settings.projection = Projection::off;
  settings.tolerance = 1e-16L;
  CHECK(error_of<problems::Relaxation<long double>>("radau", settings, 5.0L) < 1e-15L);
}

TEST_CASE("slip that begins from rest is followed from 1e-12 on") {
  using Problem = SlipBegins<double>;
  MethodSettings<double> settings;
  settings.projection = Projection::off;
  settings.tolerance = 1e-10;
  std::string why;
  const MotionModel<double> model(Problem::functions());
  // Not even in the right direction.
  const auto integrator = make_integrator("radau", model, {0, 0, 1e-12, 0}, 1.0, settings, why);
  REQUIRE(integrator != nullptr);
  REQUIRE(integrator->advance_to(2.0));
  CHECK(problems::distance(integrator->state(), Problem::at(1)) < 1e-10);
  CHECK(integrator->progress().steps < 300);
  CHECK(integrator->progress().rejected < integrator->progress().steps);
}
