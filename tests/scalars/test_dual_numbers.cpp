// gauss::Dual by itself: every function that Math offers, against its derivative in closed form and against differences.

#include <cmath>

#include "catch_shim.hpp"
#include "gauss/scalar/dual.hpp"
#include "gauss/scalar/xsimd.hpp"
#include "zoo.hpp"

namespace {

using S = gauss::Dual<double, 2>;
using M = gauss::Math<S>;

/// d/dx f by a central difference in long double, good to eleven digits.
template <class F>
double slope(const F& f, double x) {
  const long double h = 1e-5L;
  return static_cast<double>((f(x + h) - f(x - h)) / (2 * h));
}

}  // namespace

TEST_CASE("the tangents of every function are its differences") {
  using Wide = gauss::Math<long double>;
  const double at = 0.37;
  const S x = S::variable(at, 1);
#define GAUSS_CHECK_FUNCTION(f)                       \
  CHECK(M::f(x).value == gauss::Math<double>::f(at)); \
  CHECK(M::f(x).tangent[0] == 0);                     \
  CHECK(M::f(x).tangent[1] == Approx(slope([](long double u) { return Wide::f(u); }, at)));
  GAUSS_CHECK_FUNCTION(sin)
  GAUSS_CHECK_FUNCTION(cos)
  GAUSS_CHECK_FUNCTION(tan)
  GAUSS_CHECK_FUNCTION(asin)
  GAUSS_CHECK_FUNCTION(acos)
  GAUSS_CHECK_FUNCTION(atan)
  GAUSS_CHECK_FUNCTION(exp)
  GAUSS_CHECK_FUNCTION(log)
  GAUSS_CHECK_FUNCTION(sinh)
  GAUSS_CHECK_FUNCTION(cosh)
  GAUSS_CHECK_FUNCTION(tanh)
  GAUSS_CHECK_FUNCTION(sqrt)
#undef GAUSS_CHECK_FUNCTION
}

TEST_CASE("functions of two variables have a tangent by each") {
  const S x = S::variable(0.8, 0), y = S::variable(-1.3, 1);
  const S angle = M::atan2(y, x);
  CHECK(angle.tangent[0] == Approx(slope([](long double u) { return std::atan2(-1.3L, u); }, 0.8)));
  CHECK(angle.tangent[1] == Approx(slope([](long double u) { return std::atan2(u, 0.8L); }, -1.3)));
  const S power = M::pow(x, y);
  CHECK(power.tangent[0] == Approx(slope([](long double u) { return std::pow(u, -1.3L); }, 0.8)));
  CHECK(power.tangent[1] == Approx(slope([](long double u) { return std::pow(0.8L, u); }, -1.3)));
  const S quotient = x / y - x * y + (-x);
  CHECK(quotient.tangent[0] == Approx(1 / -1.3 + 1.3 - 1));
  CHECK(quotient.tangent[1] == Approx(-0.8 / (1.3 * 1.3) - 0.8));
}

TEST_CASE("what does not move has no tangent, even where the slope is infinite") {
  CHECK(M::sqrt(S(0.0)).tangent[0] == 0);
  CHECK(M::asin(S(1.0)).tangent[0] == 0);
  CHECK(M::pow(S(-2.0), S(2.0)).tangent[0] == 0);
  CHECK(M::pow(S::variable(-2.0, 0), S(3.0)).tangent[0] == Approx(12));
  CHECK_FALSE(std::isfinite(M::sqrt(S::variable(0.0, 0)).tangent[0]));
}

TEST_CASE("a tangent that is not finite is reported, since it is a result") {
  CHECK_FALSE(M::not_finite(S(1.0), S::variable(2.0, 1)));
  CHECK(M::not_finite(S(1.0), M::sqrt(S::variable(0.0, 1))));
}

TEST_CASE("dual numbers of dual numbers are second derivatives") {
  using Inner = gauss::Dual<double, 1>;
  using Outer = gauss::Dual<Inner, 1>;
  using Math = gauss::Math<Outer>;
  Outer x(Inner::variable(0.6, 0));
  x.tangent[0] = Inner(1.0);
  const Outer y = Math::sqrt(x) * Math::sin(x);
  // (√x sin x)'' = cos x/√x − sin x/(4 x^{3/2}) − √x sin x
  const double root = std::sqrt(0.6);
  CHECK(y.tangent[0].tangent[0] ==
        Approx(std::cos(0.6) / root - std::sin(0.6) / (4 * 0.6 * root) - root * std::sin(0.6)));
}

TEST_CASE("emitted code takes dual numbers of batches, each lane with its own tangents") {
  using Batch = xsimd::batch<double>;
  using Lanes = gauss::Dual<Batch, 2>;
  namespace model = models::zoo;
  double values[Batch::size];
  for (std::size_t i = 0; i < Batch::size; ++i) values[i] = 0.3 + 0.05 * static_cast<double>(i);
  const model::State<Lanes> state{{Lanes::variable(Batch::load_unaligned(values), 0), Lanes::variable(Batch(0.7), 1)}};
  model::Functions<Lanes> f;
  const auto status = model::functions(Lanes(0), state, {}, model::prepare(model::Parameters<Lanes>{}), f);
  CHECK_FALSE(status.any());
  for (std::size_t lane = 0; lane < Batch::size; ++lane) {
    const model::State<S> alone{{S::variable(values[lane], 0), S::variable(0.7, 1)}};
    model::Functions<S> expected;
    CHECK(model::functions(S(0), alone, {}, model::prepare(model::Parameters<S>{}), expected) == gauss::Status::ok);
    for (int i = 0; i < 12; ++i) {
      CHECK(f.value[i].value.get(lane) == Approx(expected.value[i].value));
      for (int k = 0; k < 2; ++k) CHECK(f.value[i].tangent[k].get(lane) == Approx(expected.value[i].tangent[k]));
    }
  }
}
