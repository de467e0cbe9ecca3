// A mass matrix without inverse: an angle that has no inertia of its own, which constraints give the motion of x and y.

#include <algorithm>
#include <cmath>

#include "registry.hpp"
#include "weightless_angle.hpp"

namespace hard_cases {

namespace {

namespace model = gauss::weightless_angle;

constexpr double k_gravity = 9.81, k_length = 1;

/// M with 1e-12 kg m^2 on the diagonal, so that it has an inverse: a = M^-1 (Q + b^T lambda).
double regularised(double theta, double rate) {
  const double tiny = 1e-12, c = std::cos(theta), s = std::sin(theta);
  const double b[2][3] = {{1, 0, -k_length * c}, {0, 1, -k_length * s}};
  const double inverse[3] = {1, 1, 1 / tiny}, force[3] = {0, -k_gravity, 0};
  const double drift[2] = {k_length * s * rate * rate, -k_length * c * rate * rate};
  double response[2][2] = {}, right[2];
  for (int i = 0; i < 2; ++i) {
    right[i] = -drift[i];
    for (int k = 0; k < 3; ++k) {
      right[i] -= b[i][k] * inverse[k] * force[k];
      for (int j = 0; j < 2; ++j) response[i][j] += b[i][k] * inverse[k] * b[j][k];
    }
  }
  const double determinant = response[0][0] * response[1][1] - response[0][1] * response[1][0];
  const double lambda[2] = {(right[0] * response[1][1] - right[1] * response[0][1]) / determinant,
                            (right[1] * response[0][0] - right[0] * response[1][0]) / determinant};
  return inverse[2] * (b[0][2] * lambda[0] + b[1][2] * lambda[1]);
}

}  // namespace

std::vector<Figure> singular_mass(const Scope&) {
  const auto prepared = model::prepare(model::Parameters<double>{});
  double naive = 0, ours = 0;
  for (int i = 0; i < 1000; ++i) {
    const double theta = 0.1 + 0.00625 * i, rate = 1 + 0.001 * i;
    const model::State<double> state{{k_length * std::sin(theta), -k_length * std::cos(theta), theta,
                                      k_length * std::cos(theta) * rate, k_length * std::sin(theta) * rate, rate}};
    model::Derivative<double> derivative{};
    const double exact = -k_gravity / k_length * std::sin(theta);
    if (rhs(0.0, state, {}, prepared, derivative) != gauss::Status::ok) ours = k_breaks_down;
    grow(ours, (derivative.theta_ddot() - exact) / k_gravity);
    grow(naive, (regularised(theta, rate) - exact) / k_gravity);
  }
  // The bar of the catalogue is for one state; theta'' is a difference of terms of this size here.
  return {{"H06", "error of theta'' over g/l, 1000 states; naive: 1e-12 kg m^2 added", "1", naive, ours, 1e-14}};
}

}  // namespace hard_cases
