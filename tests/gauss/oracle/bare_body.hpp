#pragma once
// Rigid bodies as six mass points, and rotations, for the oracle.

#include <string>

#include "gauss/oracle/real.hpp"

namespace gaussgen::oracle {

using Quaternion = std::array<Real, 4>;
using Mat3 = std::array<Vec3, 3>;

struct Body {
  Vec mass;
  std::vector<Vec3> points;  ///< about the mass centre, in body axes
};

/// Points at ±p_i on the axes, a sixth of the mass each: I_xx = m/3 (p_y² + p_z²) and so on.
Body triaxial_body(const Real& mass, const Vec3& p);
Body isotropic_body(const Real& mass, const Real& inertia);

/// The body turned by R in its own axes.
Body turned(Body body, const Mat3& R);

std::vector<Vec3> placed(const Body& body, const Vec3& centre, const Mat3& attitude);

Mat3 euler_matrix(const std::string& sequence, const Vec3& angles);
Mat3 matrix(const Quaternion& e);
Quaternion product(const Quaternion& a, const Quaternion& b);
/// The unit quaternion of the rotation vector θ, exactly.
Quaternion exponential(const Vec3& theta);
/// ω of e(θ) = exp(θ) e (in space) or e exp(θ) (in the body), by a difference quotient along θ + θ̇ τ.
Vec3 angular_velocity(const Vec3& theta, const Vec3& theta_dot, const Quaternion& e, bool in_space);
/// ė = ½ ω e or ½ e ω.
Quaternion quaternion_rate(const Quaternion& e, const Vec3& omega, bool in_space);

}  // namespace gaussgen::oracle
