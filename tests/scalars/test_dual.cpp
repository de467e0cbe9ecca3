// A type of a user's own, with functions in its namespace and nothing of gauss.

#include <cmath>

#include "catch_shim.hpp"
#include "pendulum.hpp"

namespace user {

struct Dual {
  double value = 0;
  double slope = 0;
  Dual() = default;
  explicit Dual(double v, double s = 0) : value(v), slope(s) {}
};

Dual operator-(const Dual& a) { return Dual(-a.value, -a.slope); }
Dual operator+(const Dual& a, const Dual& b) { return Dual(a.value + b.value, a.slope + b.slope); }
Dual operator-(const Dual& a, const Dual& b) { return a + -b; }
Dual operator*(const Dual& a, const Dual& b) { return Dual(a.value * b.value, a.slope * b.value + a.value * b.slope); }
Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return Dual(quotient, (a.slope - quotient * b.slope) / b.value);
}
bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
Dual sin(const Dual& a) { return Dual(std::sin(a.value), std::cos(a.value) * a.slope); }
Dual cos(const Dual& a) { return Dual(std::cos(a.value), -std::sin(a.value) * a.slope); }

}  // namespace user

TEST_CASE("derivatives come out of the emitted code with a type of automatic differentiation") {
  using user::Dual;
  namespace model = gauss::pendulum;
  const auto prepared = model::prepare(model::Parameters<Dual>{});
  const model::State<Dual> state{{Dual(0.4, 1), Dual(0.2)}};
  model::Derivative<Dual> derivative;
  CHECK(model::rhs(Dual(0), state, {}, prepared, derivative) == gauss::Status::ok);
  CHECK(derivative.theta_ddot().slope == Approx(-9.81 / 0.7 * std::cos(0.4)));
}
