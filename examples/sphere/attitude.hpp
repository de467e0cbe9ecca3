#pragma once
// How the ball is turned: quaternions, and the attitude that belongs to the closed form.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "closed_form.hpp"

namespace sphere {

/// The larger of two errors; NaN counts as infinite, where std::max may lose it.
inline double worse(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b);
}

/// Unit quaternion, body to space, scalar first.
template <class S>
using Quaternion = std::array<S, 4>;

template <class S>
Quaternion<S> product(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

template <class S>
Quaternion<S> about_z(S angle) {
  using std::cos;
  using std::sin;
  return {cos(angle / 2), 0, 0, sin(angle / 2)};
}

/// z-x-z: precession psi, nutation theta, spin phi about moving axes.
template <class S>
Quaternion<S> from_euler(S psi, S theta, S phi) {
  using std::cos;
  using std::sin;
  return product(product(about_z(psi), Quaternion<S>{cos(theta / 2), sin(theta / 2), 0, 0}), about_z(phi));
}

/// Angle (rad) of the turn that takes one attitude to the other. From the vector part: accurate for tiny angles.
template <class S>
S angle_between(const Quaternion<S>& a, const Quaternion<S>& b) {
  const Quaternion<S> turn = product(Quaternion<S>{a[0], -a[1], -a[2], -a[3]}, b);
  return 2 * std::asin(std::min<S>(1, std::sqrt(turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3])));
}

/// The attitude of the closed form. In axes that go round with the ball its angular velocity is
/// (omega_r, omega_chi, omega_z - chi_dot), known as a function of time, and p' = 1/2 Omega p is linear: so p is summed as a
/// Taylor series, step after step, in long double. No equation of motion enters, neither ours nor another.
class AttitudeOfClosedForm {
 public:
  using Real = long double;

  AttitudeOfClosedForm(const Data& data, const Quaternion<Real>& start) : d_(data), p_(start) {
    const Real k = Real(2) / 5;
    const Real chi_dot = d_.chi_dot;
    nu_ = std::abs(chi_dot) * std::sqrt(k / (1 + k));
    a0_ = -(k * Real(d_.r) * chi_dot * Real(d_.omega_r) + Real(d_.g)) / (1 + k);
  }

  /// The attitude at t, which must not decrease from call to call.
  Quaternion<Real> at(Real t) {
    while (t - t_ > k_step) advance(k_step);
    if (t > t_) advance(t - t_);
    return product(about_z(Real(d_.chi_dot) * t_), p_);
  }

 private:
  // |Omega| h / 2 < 1 for the speeds of this example, so the remainder is below 1 / order!.
  static constexpr int k_order = 28;
  static constexpr Real k_step = Real(1) / 128;
  using Series = std::array<Real, k_order + 2>;

  // Of z(t_ + tau): the derivatives of a harmonic function repeat.
  Series height_series() const {
    const Real sine = std::sin(nu_ * t_);
    const Real cosine = std::cos(nu_ * t_);
    const Real mean = a0_ / (nu_ * nu_);
    Series z{};
    z[0] = Real(d_.z_dot) / nu_ * sine - mean * cosine;
    z[1] = Real(d_.z_dot) * cosine + nu_ * mean * sine;
    for (std::size_t n = 2; n < z.size(); ++n) z[n] = -nu_ * nu_ * z[n - 2] / Real(n * (n - 1));
    z[0] += mean;
    return z;
  }

  void advance(Real h) {
    const Series z = height_series();
    const Real r = d_.r;
    const Real chi_dot = d_.chi_dot;
    const auto omega = [&](std::size_t n) -> Quaternion<Real> {
      Quaternion<Real> term{0, chi_dot * z[n] / r, Real(n + 1) * z[n + 1] / r, 0};
      if (n == 0) term[1] += Real(d_.omega_r);
      if (n == 0) term[3] = -(Real(d_.R) - r) * chi_dot / r - chi_dot;
      return term;
    };
    std::array<Quaternion<Real>, k_order + 1> p{};
    p[0] = p_;
    for (std::size_t n = 0; n < k_order; ++n) {
      for (std::size_t j = 0; j <= n; ++j) {
        const Quaternion<Real> term = product(omega(j), p[n - j]);
        for (std::size_t i = 0; i < 4; ++i) p[n + 1][i] += term[i] / Real(2 * (n + 1));
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      p_[i] = 0;
      for (std::size_t n = p.size(); n-- > 0;) p_[i] = p_[i] * h + p[n][i];
    }
    t_ += h;
  }

  Data d_;
  Real nu_ = 0;
  Real a0_ = 0;
  Real t_ = 0;
  Quaternion<Real> p_;  // body to the axes e_r, e_chi, e_z; at t = 0 these are the space axes
};

}  // namespace sphere
