#pragma once
// The ball in the cylinder without any generated code: the classical solution (Routh; Neimark & Fufaev).

#include <array>
#include <cmath>

namespace sphere {

/// Components along e_r (outward, towards the contact), e_chi (along the circumference), e_z (up).
using CylinderVector = std::array<double, 3>;

struct Data {
  double m = 0.5;      // kg
  double r = 0.1;      // m, ball
  double R = 0.6;      // m, cylinder
  double g = 9.81;     // m/s^2
  double chi_dot = 4;  // rad/s, at t = 0
  double z_dot = 0.7;  // m/s, at t = 0; the centre starts at height 0
  double omega_r = 2;  // rad/s, at t = 0
};

struct Motion {
  double chi, chi_dot;
  double z, z_dot;
  CylinderVector omega;     // rad/s
  CylinderVector reaction;  // N, on the ball at the contact point: normal, tangential, axial
};

/// The height is harmonic: z'' + nu^2 z = a0. Everything else follows from it and from rolling.
class ClosedForm {
 public:
  explicit ClosedForm(const Data& data) : d_(data) {
    constexpr double k = 2.0 / 5;  // J / (m r^2) of a homogeneous ball
    nu_ = std::abs(d_.chi_dot) * std::sqrt(k / (1 + k));
    a0_ = -(k * d_.r * d_.chi_dot * d_.omega_r + d_.g) / (1 + k);
  }

  Motion at(double t) const {
    const double sine = std::sin(nu_ * t);
    const double cosine = std::cos(nu_ * t);
    Motion now{};
    now.chi_dot = d_.chi_dot;
    now.chi = d_.chi_dot * t;
    now.z = d_.z_dot / nu_ * sine + a0_ / (nu_ * nu_) * (1 - cosine);
    now.z_dot = d_.z_dot * cosine + a0_ / nu_ * sine;
    now.omega = {d_.omega_r + d_.chi_dot * now.z / d_.r, now.z_dot / d_.r, -(d_.R - d_.r) * d_.chi_dot / d_.r};
    now.reaction = {-d_.m * (d_.R - d_.r) * d_.chi_dot * d_.chi_dot, 0, d_.m * (acceleration_at(now.z) + d_.g)};
    return now;
  }

  double frequency() const { return nu_; }
  /// z'' at height z.
  double acceleration_at(double z) const { return a0_ - nu_ * nu_ * z; }
  /// Amplitude about the mean height a0 / nu^2.
  double amplitude() const { return std::hypot(d_.z_dot / nu_, mean_height()); }
  double mean_height() const { return a0_ / (nu_ * nu_); }
  double lowest_height() const { return mean_height() - amplitude(); }
  const Data& data() const { return d_; }

 private:
  Data d_;
  double nu_ = 0;  // rad/s
  double a0_ = 0;  // m/s^2
};

}  // namespace sphere
