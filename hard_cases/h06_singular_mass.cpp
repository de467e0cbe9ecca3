// A mass matrix without inverse: an angle that has no inertia of its own, which constraints give the motion of x and y; a rod and a hub without
// mass between the pivot and a rod.

#include <algorithm>
#include <cmath>

#include "massless_hub.hpp"
#include "process.hpp"
#include "registry.hpp"
#include "weightless_angle.hpp"

namespace hard_cases {

namespace {

namespace model = gauss::weightless_angle;
namespace hub = gauss::massless_hub;

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

struct Errors {
  double naive = 0, ours = 0;
  double seconds_naive = 0, seconds_ours = 0;
};

Errors weightless_angle() {
  const auto prepared = model::prepare(model::Parameters<double>{});
  Errors result;
  for (int i = 0; i < 1000; ++i) {
    const double theta = 0.1 + 0.00625 * i, rate = 1 + 0.001 * i;
    const model::State<double> state{{k_length * std::sin(theta), -k_length * std::cos(theta), theta,
                                      k_length * std::cos(theta) * rate, k_length * std::sin(theta) * rate, rate}};
    model::Derivative<double> derivative{};
    const double exact = -k_gravity / k_length * std::sin(theta);
    Stopwatch of_ours;
    if (rhs(0.0, state, {}, prepared, derivative) != gauss::Status::ok) result.ours = k_breaks_down;
    result.seconds_ours += of_ours.seconds();
    grow(result.ours, (derivative.theta_ddot() - exact) / k_gravity);
    grow(result.naive, (regularised(theta, rate) - exact) / k_gravity);
  }
  return result;
}

constexpr int k_speeds = 9, k_rows = 7;

/// Accelerations by a = g^-1 (f + b^T lambda) with 1e-12 in place of inertias that are 0, and S = b g^-1 b^T without pivots.
void regularised(const hub::LinearSystem<double>& system, double (&a)[k_speeds]) {
  // The mass centre is the origin of the rod that has mass, so that g is diagonal.
  double inverse[k_speeds], s[k_rows][k_rows + 1];
  for (int i = 0; i < k_speeds; ++i) inverse[i] = 1 / (system.g[i][i] == 0 ? 1e-12 : system.g[i][i]);
  for (int mu = 0; mu < k_rows; ++mu) {
    s[mu][k_rows] = -system.drift[mu];
    for (int i = 0; i < k_speeds; ++i) s[mu][k_rows] -= system.b[mu][i] * inverse[i] * system.f[i];
    for (int nu = 0; nu < k_rows; ++nu) {
      s[mu][nu] = 0;
      for (int i = 0; i < k_speeds; ++i) s[mu][nu] += system.b[mu][i] * inverse[i] * system.b[nu][i];
    }
  }
  for (int k = 0; k < k_rows; ++k) {
    for (int i = k + 1; i < k_rows; ++i) {
      const double factor = s[i][k] / s[k][k];
      for (int j = k; j <= k_rows; ++j) s[i][j] -= factor * s[k][j];
    }
  }
  double lambda[k_rows];
  for (int i = k_rows - 1; i >= 0; --i) {
    lambda[i] = s[i][k_rows];
    for (int j = i + 1; j < k_rows; ++j) lambda[i] -= s[i][j] * lambda[j];
    lambda[i] /= s[i][i];
  }
  for (int i = 0; i < k_speeds; ++i) {
    a[i] = system.f[i];
    for (int mu = 0; mu < k_rows; ++mu) a[i] += system.b[mu][i] * lambda[mu];
    a[i] *= inverse[i];
  }
}

/// A rod with mass on an arm without: angles p of the arm and q of the rod, from the vertical.
struct Angles {
  double p, q, p_dot, q_dot;
};

/// Lagrange's equations of the two angles, solved by hand: A p'' + B q'' = right hand sides.
void double_pendulum(const hub::Parameters<double>& of, const Angles& at, double& p_ddot, double& q_ddot) {
  const double a = of.L + of.c, b = of.L / 2, c = std::cos(at.p - at.q), s = std::sin(at.p - at.q);
  const double inertia = of.m * of.L * of.L / 12;
  const double first = -b * s * at.q_dot * at.q_dot - of.g * std::sin(at.p);
  const double second = of.m * b * (a * s * at.p_dot * at.p_dot - of.g * std::sin(at.q));
  // The first equation is divided by m a: a p'' + b c q'' = first, m a b c p'' + (J + m b^2) q'' = second.
  q_ddot = (second - of.m * b * c * first) / (inertia + of.m * b * b * s * s);
  p_ddot = (first - b * c * q_ddot) / a;
}

/// Places follow from the angles: a rod that hangs by theta from its upper end has its middle at -L/2 (sin, cos) in (x, z).
hub::State<double> state_of(const hub::Parameters<double>& of, const Angles& at) {
  hub::State<double> state{};
  double x = 0, z = 0, x_dot = 0, z_dot = 0;
  const auto go = [&](double length, double angle, double rate) {
    x -= length * std::sin(angle), z -= length * std::cos(angle);
    x_dot -= length * std::cos(angle) * rate, z_dot += length * std::sin(angle) * rate;
  };
  const auto put = [&](int part, double angle, double rate) {
    const double places[] = {z, x, angle}, rates[] = {z_dot, x_dot, rate};
    std::copy_n(places, 3, state.values + 3 * part);
    std::copy_n(rates, 3, state.values + k_speeds + 3 * part);
  };
  go(of.L / 2, at.p, at.p_dot);
  put(0, at.p, at.p_dot);
  go(of.L / 2, at.p, at.p_dot);
  put(1, at.p, at.p_dot);
  go(of.c, at.p, at.p_dot);
  go(of.L / 2, at.q, at.q_dot);
  put(2, at.q, at.q_dot);
  return state;
}

Errors massless_hub() {
  const hub::Parameters<double> parameters;
  const auto prepared = prepare(parameters);
  Errors result;
  for (int i = 0; i < 1000; ++i) {
    const Angles at{3 * std::sin(0.7 * i), 3 * std::cos(1.1 * i), 2 * std::cos(1.3 * i), 2 * std::sin(0.9 * i)};
    const hub::State<double> state = state_of(parameters, at);
    double p_ddot = 0, q_ddot = 0;
    double_pendulum(parameters, at, p_ddot, q_ddot);
    const double size = std::hypot(p_ddot, q_ddot);
    Stopwatch of_ours;
    hub::Derivative<double> derivative{};
    if (rhs(0.0, state, {}, prepared, derivative) != gauss::Status::ok) result.ours = k_breaks_down;
    result.seconds_ours += of_ours.seconds();
    for (const double p : {derivative.theta_1_ddot(), derivative.theta_2_ddot()})
      grow(result.ours, (p - p_ddot) / size);
    grow(result.ours, (derivative.theta_3_ddot() - q_ddot) / size);
    Stopwatch of_naive;
    hub::LinearSystem<double> system{};
    (void)linear_system(0.0, state, {}, prepared, system);
    double a[k_speeds];
    regularised(system, a);
    result.seconds_naive += of_naive.seconds();
    grow(result.naive, (a[2] - p_ddot) / size);
    grow(result.naive, (a[8] - q_ddot) / size);
  }
  return result;
}

/// Of a hub that nothing keys: at run time a status, and the generator says which angle nothing determines.
double undetermined() {
  hub::Parameters<double> loose;
  loose.k = 0;
  hub::Derivative<double> derivative{};
  const gauss::Status status = rhs(0.0, state_of(loose, {0.3, 0.5, 0, 0}), {}, prepare(loose), derivative);
  const Outcome outcome = run_program("sed '/^  key:/d' '" GAUSS_SOURCE_DIR
                                      "/hard_cases/models/massless_hub.yaml' | '" GAUSS_GEN "' --check -");
  const std::size_t message = outcome.said.find("the mass matrix is singular, nothing");
  const bool is_named = message != std::string::npos && outcome.said.find("theta_2", message) != std::string::npos;
  return (status == gauss::Status::singular_mass_matrix ? 0 : 1) + (is_named ? 0 : 1);
}

}  // namespace

std::vector<Figure> singular_mass(const Scope&) {
  const Errors angle = weightless_angle(), of_hub = massless_hub();
  // The bar of the catalogue is for one state; theta'' is a difference of terms of this size here.
  return {
      {"H06", "error of theta'' over g/l, 1000 states", "1", angle.naive, angle.ours, 1e-14, 0, angle.seconds_ours,
       "naive: 1e-12 kg m^2 added"},
      {"H06.hub", "error of the angles' accelerations, rod and hub without mass, 1000 states", "1", of_hub.naive,
       of_hub.ours, 1e-13, of_hub.seconds_naive, of_hub.seconds_ours, "naive: 1e-12 kg and kg m^2 added"},
      {"H06.named",
       "of 2 answers about a hub that may turn as it likes, at run time and of the generator, those that do not say so",
       "1", std::nullopt, undetermined(), 0}};
}

}  // namespace hard_cases
