// Forces with kinks, jumps and tables, against closed forms and against a spline that is computed here.

#include <cmath>
#include <vector>

#include "catch_shim.hpp"
#include "falling.hpp"
#include "gauss/model_concept.hpp"
#include "gauss/simulate/simulation.hpp"
#include "springs.hpp"

namespace gauss::falling {
GAUSS_MODEL(Model, gauss::falling);
}
namespace gauss::springs {
GAUSS_MODEL(Model, gauss::springs);
}

namespace {

namespace falling = gauss::falling;
namespace springs = gauss::springs;

template <class Model>
auto simulation_from(const typename Model::template State<double>& start) {
  const auto prepared = prepare(typename Model::template Parameters<double>{});
  return gauss::simulate::Simulation(
      gauss::integrate::bind_model<Model>(prepared, typename Model::template Inputs<double>{}), start);
}

/// y, y', y'' of the natural cubic spline at x, straight on outside (Press et al., Numerical Recipes, section 3.3).
class NaturalSpline {
 public:
  using Real = long double;

  NaturalSpline(std::vector<Real> x, std::vector<Real> y) : x_(std::move(x)), y_(std::move(y)), m_(x_.size(), 0) {
    std::vector<Real> u(x_.size(), 0);
    for (std::size_t i = 1; i + 1 < x_.size(); ++i) {
      const Real sig = (x_[i] - x_[i - 1]) / (x_[i + 1] - x_[i - 1]);
      const Real p = sig * m_[i - 1] + 2;
      m_[i] = (sig - 1) / p;
      const Real bend = (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]) - (y_[i] - y_[i - 1]) / (x_[i] - x_[i - 1]);
      u[i] = (6 * bend / (x_[i + 1] - x_[i - 1]) - sig * u[i - 1]) / p;
    }
    for (std::size_t i = x_.size() - 1; i-- > 0;) m_[i] = m_[i] * m_[i + 1] + u[i];
  }

  Real value(Real x) const {
    if (x < x_.front()) return y_.front() + (x - x_.front()) * slope(x);
    if (x > x_.back()) return y_.back() + (x - x_.back()) * slope(x);
    const std::size_t k = interval(x);
    const Real h = x_[k + 1] - x_[k], a = (x_[k + 1] - x) / h, b = (x - x_[k]) / h;
    return a * y_[k] + b * y_[k + 1] + ((a * a * a - a) * m_[k] + (b * b * b - b) * m_[k + 1]) * h * h / 6;
  }

  Real slope(Real x) const {
    x = std::min(std::max(x, x_.front()), x_.back());
    const std::size_t k = interval(x);
    const Real h = x_[k + 1] - x_[k], a = (x_[k + 1] - x) / h, b = (x - x_[k]) / h;
    return (y_[k + 1] - y_[k]) / h + ((1 - 3 * a * a) * m_[k] + (3 * b * b - 1) * m_[k + 1]) * h / 6;
  }

 private:
  std::size_t interval(Real x) const {
    std::size_t k = 0;
    while (k + 2 < x_.size() && x >= x_[k + 1]) ++k;
    return k;
  }

  std::vector<Real> x_, y_, m_;
};

const NaturalSpline k_curve({-2, -1.2L, -0.1L, 0.3L, 1.5L, 2}, {0.3L, -0.4L, 1.1L, 0.9L, -0.7L, 0.2L});

}  // namespace

TEST_CASE("a body with quadratic drag falls by tanh, and rises by tan") {
  const double c = 0.35, m = 2, g = 9.81;
  const double limit = std::sqrt(m * g / c), rate = g / limit;
  falling::State<double> start{};
  auto fall = simulation_from<falling::Model>(start);
  for (const double t : {0.1, 0.5, 1.0, 3.0}) {
    INFO("t = " << t);
    REQUIRE(fall.advance_to(t));
    CHECK(fall.state().x_dot() == Approx(limit * std::tanh(rate * t)).epsilon(1e-9));
    CHECK(fall.state().x() == Approx(limit / rate * std::log(std::cosh(rate * t))).epsilon(1e-9));
  }
  start.x_dot() = -12;
  const double top = std::atan(12 / limit) / rate;
  auto rise = simulation_from<falling::Model>(start);
  REQUIRE(rise.advance_to(top / 2));
  CHECK(rise.state().x_dot() == Approx(-limit * std::tan(rate * top / 2)).epsilon(1e-9));
  REQUIRE(rise.advance_to(top + 0.4));
  CHECK(rise.state().x_dot() == Approx(limit * std::tanh(rate * 0.4)).epsilon(1e-7));
}

TEST_CASE("dry friction acts against the motion, and on a body at rest not at all") {
  const auto acceleration = [](double speed) {
    falling::State<double> state{};
    state.s_dot() = speed;
    falling::Derivative<double> derivative;
    const auto prepared = prepare(falling::Parameters<double>{});
    REQUIRE(rhs(0.0, state, falling::Inputs<double>{}, prepared, derivative) == gauss::Status::ok);
    return derivative.s_ddot();
  };
  CHECK(acceleration(1e-12) == Approx(-0.4 * 9.81).epsilon(1e-14));
  CHECK(acceleration(-300) == Approx(0.4 * 9.81).epsilon(1e-14));
  CHECK(acceleration(0) == 0);
}

TEST_CASE("a spring that pulls softer than it pushes has half a period of each") {
  springs::State<double> start{};
  start.x() = 0.3;
  const double period = std::acos(-1.0) * (std::sqrt(0.5 / 8) + std::sqrt(0.5 / 3));
  auto simulation = simulation_from<springs::Model>(start);
  REQUIRE(simulation.advance_to(period));
  CHECK(simulation.state().x() == Approx(0.3).epsilon(1e-7));
  CHECK(simulation.state().x_dot() == Approx(0).margin(1e-7));
  // Half a period of the other side later it turns there, with the same energy: 3 a^2 = 8 b^2.
  const double to_the_other = std::acos(-1.0) / 2 * (std::sqrt(0.5 / 3) + std::sqrt(0.5 / 8));
  REQUIRE(simulation.advance_to(period + to_the_other));
  CHECK(simulation.state().x() == Approx(-0.3 * std::sqrt(3.0 / 8)).epsilon(1e-7));
}

TEST_CASE("a force by a spline is its value, one by a potential its slope, inside and outside of the points") {
  const auto prepared = prepare(springs::Parameters<double>{});
  for (double at = -3.5; at < 3.5; at += 0.0625) {
    INFO("at " << at);
    springs::State<double> state{};
    state.y() = state.z() = state.w() = state.v() = at;
    springs::Derivative<double> derivative;
    REQUIRE(rhs(0.0, state, springs::Inputs<double>{}, prepared, derivative) == gauss::Status::ok);
    const bool is_inside = at >= -2 && at < 2;
    CHECK(derivative.y_ddot() == Approx(static_cast<double>(k_curve.value(at) / 0.5L)).epsilon(1e-13).margin(1e-13));
    CHECK(derivative.z_ddot() == Approx(static_cast<double>(-k_curve.slope(at) / 0.5L)).epsilon(1e-13).margin(1e-13));
    CHECK(derivative.w_ddot() == (is_inside ? Approx(derivative.z_ddot()).epsilon(1e-14) : Approx(0.0)));
    const double line = at < -1 ? 3 : at < 0 ? 1 - 2 * at : at < 2 ? 1 + at / 2 : 2;
    CHECK(derivative.v_ddot() == Approx(line / 0.5).epsilon(1e-14));
  }
}

TEST_CASE("energy is kept in a landscape by a spline") {
  springs::State<double> state{};
  state.z() = -0.1;
  state.z_dot() = 0.3;
  const auto prepared = prepare(springs::Parameters<double>{});
  auto simulation = simulation_from<springs::Model>(state);
  springs::Energy<double> before, after;
  REQUIRE(energy(0.0, state, prepared, before) == gauss::Status::ok);
  REQUIRE(simulation.advance_to(1.5));
  // The other bodies of the model do work that no potential has.
  springs::State<double> alone = simulation.state();
  for (double* speed : {&alone.x_dot(), &alone.y_dot(), &alone.w_dot(), &alone.v_dot()}) *speed = 0;
  alone.x() = alone.y() = alone.w() = alone.v() = 0;
  REQUIRE(energy(0.0, alone, prepared, after) == gauss::Status::ok);
  CHECK(std::abs(simulation.state().z() + 0.1) > 0.5);
  CHECK(after.total == Approx(before.total).epsilon(1e-9));
}
