// Sines and cosines of registers: their error, that lanes do not meet, and emitted code that asks for several at a time.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "catch_shim.hpp"
#include "gauss/scalar/vectorised.hpp"
#include "pendulum.hpp"

namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
using Batch = xsimd::batch<double>;

double ulps(double found, const Wide& expected) {
  int exponent = 0;
  std::frexp(static_cast<double>(expected), &exponent);
  return static_cast<double>(abs(Wide(found) - expected)) / std::ldexp(1.0, exponent - 53);
}

double error_at(double x) {
  Batch sine, cosine;
  gauss::Math<Batch>::sincos(Batch(x), sine, cosine);
  return std::max(ulps(sine.get(0), sin(Wide(x))), ulps(cosine.get(0), cos(Wide(x))));
}

}  // namespace

TEST_CASE("sines and cosines of registers err by less than 2.5 units in the last place, near multiples of pi/2 too") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  double worst = 0;
  const auto see = [&](double x) { worst = std::max(worst, error_at(x)); };
  for (int i = 1; i < 4000; ++i) {
    const double multiple = i * std::acos(0.0);
    for (const double x : {10 * any(random), 1.6e6 * any(random), 1e-9 * any(random), multiple, 250 * multiple,
                           std::nextafter(multiple, 0), 0.78539816339744828 * any(random)})
      see(x);
  }
  CHECK(worst < 2.5);
  CHECK(worst > 0.4);
}

TEST_CASE("beyond a million turns, and where there is no sine, registers are as the C library") {
  for (const double x : {3e6, -4.2e7, 1e22, 1e300}) {
    CHECK(gauss::Math<Batch>::sin(Batch(x)).get(0) == Approx(std::sin(x)));
    CHECK(gauss::Math<Batch>::cos(Batch(x)).get(0) == Approx(std::cos(x)));
  }
  for (const double x : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    CHECK(std::isnan(gauss::Math<Batch>::sin(Batch(x)).get(0)));
    CHECK(std::isnan(gauss::Math<Batch>::cos(Batch(x)).get(0)));
  }
}

TEST_CASE("a lane has the same bits whatever stands beside it") {
  for (const double x : {0.3, -2.7, 55.0, 1e5}) {
    const double alone = gauss::Math<Batch>::sin(Batch(x)).get(0);
    for (const double beside : {0.1, 1e3, 1e7, 1e300, std::nan("")}) {
      double lanes[Batch::size];
      for (double& lane : lanes) lane = beside;
      lanes[Batch::size - 1] = x;
      CHECK(gauss::Math<Batch>::sin(Batch::load_unaligned(lanes)).get(Batch::size - 1) == alone);
    }
  }
}

TEST_CASE("several angles at a time have the sine and the cosine of each, however many there are") {
  using S = gauss::Vectorised<double>;
  const auto near = [](S found, double expected) { return std::fabs(found.value - expected) < 1e-15; };
  S s[5], c[5];
  const S x[] = {0.1, -2.0, 3.5, 40.0, 1.25};
  gauss::Angles<S>::sincos(x[0], s[0], c[0], x[1], s[1], c[1]);
  for (int i = 0; i < 2; ++i) CHECK((near(s[i], std::sin(x[i].value)) && near(c[i], std::cos(x[i].value))));
  gauss::Angles<S>::sincos(x[0], s[0], c[0], x[1] + x[2], s[1], c[1], x[2], s[2], c[2], x[3], s[3], c[3], x[4], s[4],
                           c[4]);
  CHECK(near(s[1], std::sin(1.5)));
  for (int i = 2; i < 5; ++i) CHECK((near(s[i], std::sin(x[i].value)) && near(c[i], std::cos(x[i].value))));
}

TEST_CASE("by default several angles are those one by one, bit for bit") {
  double s[3], c[3];
  gauss::Angles<double>::sincos(0.3, s[0], c[0], -7.0, s[1], c[1], 1e9, s[2], c[2]);
  const double x[] = {0.3, -7.0, 1e9};
  for (int i = 0; i < 3; ++i) {
    double sine = 0, cosine = 0;
    gauss::Math<double>::sincos(x[i], sine, cosine);
    CHECK((s[i] == sine && c[i] == cosine));
  }
}

TEST_CASE("emitted code runs with sines and cosines together, and keeps its layout") {
  using S = gauss::Vectorised<double>;
  namespace model = gauss::pendulum;
  static_assert(sizeof(model::State<S>) == sizeof(model::State<double>));
  const auto prepared = model::prepare(model::Parameters<S>{});
  model::Derivative<S> derivative;
  CHECK(model::rhs<S>(0.0, {{0.4, 0.2}}, {}, prepared, derivative) == gauss::Status::ok);
  CHECK(derivative.theta_ddot().value == Approx(-9.81 * std::sin(0.4) / 0.7));
}
