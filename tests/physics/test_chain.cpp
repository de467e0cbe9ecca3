// A chain of bars that are copies of one file, against the equations of n bars in absolute angles: with θ_i the sum of the
// hinge angles, M_ij θ̈_j + Σ_j M'_ij sin(θ_i - θ_j) θ̇_j² = -∂V/∂θ_i, where M'_ij = l_i l_j (mass beyond the later of both, and
// half of its own), M_ij = M'_ij cos(θ_i - θ_j), and M_ii = l_i² (m_i/3 + mass beyond i). Lagrange's equations of thin bars.
#include <array>
#include <cmath>

#include "catch_shim.hpp"
#include "chain.hpp"

namespace {

namespace model = gauss::chain;
using Angles = std::array<double, 4>;

/// What is missing in equation i.
double residual(std::size_t i, const Angles& m, double l, double g, double k, const Angles& theta, const Angles& rate,
                const Angles& acceleration) {
  const auto beyond = [&](std::size_t j) {
    double sum = 0;
    for (std::size_t later = j + 1; later < m.size(); ++later) sum += m[later];
    return sum;
  };
  double sum = g * l * (m[i] / 2 + beyond(i)) * std::sin(theta[i]);
  sum += k * (theta[i] - (i > 0 ? theta[i - 1] : 0));
  if (i + 1 < m.size()) sum -= k * (theta[i + 1] - theta[i]);
  for (std::size_t j = 0; j < m.size(); ++j) {
    const std::size_t later = std::max(i, j);
    const double coupling = l * l * (i == j ? m[i] / 3 + beyond(i) : m[later] / 2 + beyond(later));
    sum += coupling * std::cos(theta[i] - theta[j]) * acceleration[j];
    if (i != j) sum += coupling * std::sin(theta[i] - theta[j]) * rate[j] * rate[j];
  }
  return sum;
}

/// Of hinge angles.
Angles absolute(Angles relative) {
  for (std::size_t i = 1; i < relative.size(); ++i) relative[i] += relative[i - 1];
  return relative;
}

}  // namespace

TEST_CASE("bars from one file make the chain that Lagrange's equations in absolute angles describe") {
  const auto prepared = prepare(model::Parameters<double>());
  model::State<double> state;
  REQUIRE(initial_state(prepared, state) == gauss::Status::ok);
  CHECK(state.bar_3_hinge() == Approx(0.6));
  const Angles rates{0.5, -1.5, 2, 0.7};
  state.bar_1_hinge_dot() = rates[0];
  state.bar_2_hinge_dot() = rates[1];
  state.bar_3_hinge_dot() = rates[2];
  state.bar_4_hinge_dot() = rates[3];
  model::Derivative<double> found;
  REQUIRE(rhs(0.0, state, {}, prepared, found) == gauss::Status::ok);

  const Angles theta = absolute({state.bar_1_hinge(), state.bar_2_hinge(), state.bar_3_hinge(), state.bar_4_hinge()});
  const Angles acceleration = absolute(
      {found.bar_1_hinge_ddot(), found.bar_2_hinge_ddot(), found.bar_3_hinge_ddot(), found.bar_4_hinge_ddot()});
  const Angles masses{1.5, 2, 2.5, 3};
  for (std::size_t i = 0; i < masses.size(); ++i) {
    INFO("equation " << i);
    CHECK(residual(i, masses, 0.5, 9.81, 3, theta, absolute(rates), acceleration) == Approx(0).margin(1e-12));
  }
}
