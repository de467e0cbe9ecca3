#pragma once
// The states at which the contenders of a case are compared and measured, in coordinates of our model: random, the same in every
// run, and such that constraints hold.
//
//   planar_chain       q_1 … q_n, relative              models/families/planar_chain_relative.yaml
//   planar_pendulum    q_1 … q_n, relative              models/families/planar_pendulum.yaml
//   spatial_chain      a_1, b_1, …, a_n, b_n            models/families/spatial_chain.yaml
//   four_bar           alpha, beta, gamma               models/four_bar.yaml
//   rolling_disc       x, y, psi, theta, phi            models/rolling_disc.yaml
//   sphere             chi, zeta, phi, psi, theta       models/sphere_in_cylinder.yaml
//   sphere_quaternion  chi, zeta, e0 … e3; chi', zeta', ω   models/sphere_in_cylinder_quaternion.yaml
//   bicycle            see bicycle_states.hpp

#include <cmath>
#include <random>
#include <stdexcept>

#include "bicycle_states.hpp"
#include "contender.hpp"

namespace bench {

class Random {
 public:
  double normal() { return normal_(engine_); }
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_()) / static_cast<double>(std::mt19937_64::max());
  }
  std::vector<double> normals(int n) {
    std::vector<double> values(static_cast<std::size_t>(n));
    for (double& value : values) value = normal();
    return values;
  }

 private:
  std::mt19937_64 engine_{1986};
  std::normal_distribution<double> normal_;
};

namespace detail {

/// The branch that the model begins on: the coupler lies above the line from its hinge to the pivot of the rocker.
inline Sample four_bar(Random& random) {
  constexpr double L1 = 0.2, L2 = 0.6, L3 = 0.5, L4 = 0.55;
  const double crank = random.between(-3.1, 3.1);
  const double x = L4 - L1 * std::cos(crank), y = -L1 * std::sin(crank);
  const double d = std::hypot(x, y);
  const double coupler = std::atan2(y, x) + std::acos((L2 * L2 + d * d - L3 * L3) / (2 * L2 * d));
  const double rocker = std::atan2(L2 * std::sin(coupler) - y, L2 * std::cos(coupler) - x);
  const double rate = 4 * random.normal();
  // The loop along the rocker and along the coupler.
  const double coupler_rate = -L1 * rate * std::sin(rocker - crank) / (L2 * std::sin(rocker - coupler));
  const double rocker_rate = -L1 * rate * std::sin(coupler - crank) / (L3 * std::sin(rocker - coupler));
  return {{crank, coupler - crank, rocker}, {rate, coupler_rate - rate, rocker_rate}};
}

inline Sample rolling_disc(Random& random) {
  constexpr double R = 0.5;
  const double psi = random.normal(), theta = random.between(0.4, 2.6), phi = random.normal();
  const double psi_dot = random.normal(), theta_dot = random.normal(), phi_dot = 3 * random.normal();
  const double s = psi_dot * std::cos(theta) + phi_dot;
  const double lean = theta_dot * std::sin(theta);
  return {{random.normal(), random.normal(), psi, theta, phi},
          {R * (lean * std::sin(psi) - s * std::cos(psi)), -R * (lean * std::cos(psi) + s * std::sin(psi)), psi_dot,
           theta_dot, phi_dot}};
}

inline Sample sphere(Random& random) {
  constexpr double r = 0.1, R = 0.6;
  const double chi = random.normal(), phi = random.normal(), psi = random.normal(), theta = random.between(0.4, 2.6);
  const double chi_dot = 3 * random.normal(), phi_dot = random.normal(), theta_dot = random.normal();
  const double psi_dot = -(R - r) / r * chi_dot - phi_dot * std::cos(theta);
  const double zeta_dot = r * (theta_dot * std::sin(psi - chi) - phi_dot * std::sin(theta) * std::cos(psi - chi));
  return {{chi, random.normal(), phi, psi, theta}, {chi_dot, zeta_dot, phi_dot, psi_dot, theta_dot}};
}

inline Sample sphere_quaternion(Random& random) {
  constexpr double r = 0.1, R = 0.6;
  const double chi = random.normal(), chi_dot = 3 * random.normal();
  std::vector<double> e = random.normals(4);
  const double length = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
  const double wx = random.normal(), wy = random.normal();
  return {{chi, random.normal(), e[0] / length, e[1] / length, e[2] / length, e[3] / length},
          {chi_dot, -r * (wx * std::sin(chi) - wy * std::cos(chi)), wx, wy, -(R - r) / r * chi_dot}};
}

}  // namespace detail

/// Of kinds that are not listed above each contender has its own states.
inline Samples samples_of(const std::string& kind, int size) {
  Random random;
  Samples samples;
  for (std::size_t i = 0; i < k_states; ++i) {
    Sample& sample = samples[i];
    if (kind == "planar_chain" || kind == "planar_pendulum") sample = {random.normals(size), random.normals(size)};
    if (kind == "spatial_chain") sample = {random.normals(2 * size), random.normals(2 * size)};
    if (kind == "four_bar") sample = detail::four_bar(random);
    if (kind == "rolling_disc") sample = detail::rolling_disc(random);
    if (kind == "sphere") sample = detail::sphere(random);
    if (kind == "sphere_quaternion") sample = detail::sphere_quaternion(random);
    if (kind == "bicycle") sample = bicycle::sample(i);
  }
  return samples;
}

}  // namespace bench
