#pragma once
// The right-hand side of the ball as a person writes it, from Newton and Euler at the contact point:
//
//   friction around the axis vanishes, so chi'' = 0 and omega_z' = 0;
//   friction along it is F = (g - r chi' omega_r) / (1/m + r²/J), omega_r = ω·e_r;
//   z'' = F/m - g and J ω' = r F (sin chi, -cos chi, 0).
//
// Speeds need not satisfy the constraints, as in emitted code.

#include <cmath>

namespace by_hand {

/// What does not change from call to call.
template <class S>
struct Constants {
  S r, g, compliance, inverse_m, r_over_J;
};

template <class S>
Constants<S> constants(S m, S r, S g, S J) {
  return {r, g, S(1) / (S(1) / m + r * r / J), S(1) / m, r / J};
}

/// y: chi, zeta, e0, e1, e2, e3, chi', zeta', ωx, ωy, ωz (space axes)
template <class Math, class S>
void quaternion(const Constants<S>& k, const S* y, S* dy) {
  S s, c;
  Math::sincos(y[0], s, c);
  const S wx = y[8], wy = y[9], wz = y[10];
  const S F = k.compliance * (k.g - k.r * (y[6] * (wx * c + wy * s)));
  const S half_x = S(0.5) * wx, half_y = S(0.5) * wy, half_z = S(0.5) * wz;
  dy[0] = y[6];
  dy[1] = y[7];
  dy[2] = -(half_x * y[3] + half_y * y[4] + half_z * y[5]);
  dy[3] = half_x * y[2] + half_y * y[5] - half_z * y[4];
  dy[4] = half_y * y[2] + half_z * y[3] - half_x * y[5];
  dy[5] = half_z * y[2] + half_x * y[4] - half_y * y[3];
  const S turn = k.r_over_J * F;
  dy[6] = S(0);
  dy[7] = F * k.inverse_m - k.g;
  dy[8] = turn * s;
  dy[9] = -(turn * c);
  dy[10] = S(0);
}

/// y: chi, zeta, phi, psi, theta and their rates. Along the line of nodes and across it,
///   theta'' + phi' psi' sin theta = -r F/J sin u,   phi'' sin theta = theta' (psi' - phi' cos theta) + r F/J cos u.
template <class Math, class S>
void euler(const Constants<S>& k, const S* y, S* dy) {
  S sin_u, cos_u, sin_theta, cos_theta;
  Math::sincos(y[3] - y[0], sin_u, cos_u);
  Math::sincos(y[4], sin_theta, cos_theta);
  const S phi_dot = y[7], psi_dot = y[8], theta_dot = y[9];
  const S across = phi_dot * sin_theta;
  const S F = k.compliance * (k.g - k.r * (y[5] * (theta_dot * cos_u + across * sin_u)));
  const S turn = k.r_over_J * F;
  for (int i = 0; i < 5; ++i) dy[i] = y[5 + i];
  const S phi_ddot = (theta_dot * (psi_dot - phi_dot * cos_theta) + turn * cos_u) / sin_theta;
  dy[5] = S(0);
  dy[6] = F * k.inverse_m - k.g;
  dy[7] = phi_ddot;
  dy[8] = across * theta_dot - phi_ddot * cos_theta;
  dy[9] = -(turn * sin_u) - across * psi_dot;
}

}  // namespace by_hand
