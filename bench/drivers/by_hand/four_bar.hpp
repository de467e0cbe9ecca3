#pragma once
// models/four_bar.yaml as a person writes it. The loop gives the accelerations of coupler and rocker by that of the crank, from its
// second derivative along the rocker and along the coupler; the equation of motion is the one along that motion.

#include "../counted.hpp"

namespace by_hand {

/// q: alpha, beta against the crank, gamma.
template <class S>
void four_bar(const S* q, const S* v, S* acceleration) {
  constexpr double L1 = 0.2, L2 = 0.6, L3 = 0.5, m1 = 0.5, m2 = 1.5, m3 = 1.2, g = 9.81, torque = 0.8;
  constexpr double M11 = m1 * L1 * L1 / 3 + m2 * L1 * L1, M22 = m2 * L2 * L2 / 3, M33 = m3 * L3 * L3 / 3,
                   k = m2 * L1 * L2 / 2;
  S s1, c1, s2, c2, s3, c3;
  bench::sine_and_cosine(q[0], s1, c1);
  bench::sine_and_cosine(S(q[0] + q[1]), s2, c2);
  bench::sine_and_cosine(q[2], s3, c3);
  const S rate = v[0] + v[1];
  const S square1 = v[0] * v[0], square2 = rate * rate, square3 = v[2] * v[2];
  const S cos21 = c1 * c2 + s1 * s2, sin21 = s2 * c1 - c2 * s1;
  const S cos31 = c1 * c3 + s1 * s3, sin31 = s3 * c1 - c3 * s1;
  const S cos32 = c2 * c3 + s2 * s3, sin32 = s3 * c2 - c3 * s2;
  const S one_over = 1.0 / sin32;
  const S along = L1 * square1;
  // α_2 = p_2 + r_2 α_1, α_3 = p_3 + r_3 α_1
  const S r2 = -(L1 / L2) * sin31 * one_over, r3 = -(L1 / L3) * sin21 * one_over;
  const S two = L2 * square2, three = L3 * square3;
  const S p2 = (along * cos31 + two * cos32 - three) * one_over * (1 / L2);
  const S p3 = (along * cos21 + two - three * cos32) * one_over * (1 / L3);
  const S M12 = k * cos21, x = k * sin21;
  const S M22r2 = M22 * r2, M33r3 = M33 * r3;
  const S mass = M11 + (M12 + M12 + M22r2) * r2 + M33r3 * r3;
  const S force = torque - (g * L1 * (m1 / 2 + m2)) * c1 + x * square2 - M12 * p2 -
                  r2 * ((g * m2 * L2 / 2) * c2 + x * square1 + M22 * p2) - r3 * ((g * m3 * L3 / 2) * c3 + M33 * p3);
  const S crank = force / mass;
  acceleration[0] = crank;
  acceleration[1] = p2 + r2 * crank - crank;
  acceleration[2] = p3 + r3 * crank;
}

}  // namespace by_hand
