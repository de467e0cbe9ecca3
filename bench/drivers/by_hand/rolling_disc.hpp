#pragma once
// models/rolling_disc.yaml as a person writes it: Newton and Euler about the contact, in axes that follow heading and inclination.
// With p, q, w the turning of these axes and s that of the disc about its axis,
//     5/4 p' = q w/4 - 3/2 q s - g/R cos θ,   3/2 s' = p q,   ψ'' sin θ = 2 θ' φ'.

#include "../counted.hpp"

namespace by_hand {

/// q: x, y, psi, theta, phi.
template <class S>
void rolling_disc(const S* q, const S* v, S* acceleration) {
  constexpr double R = 0.5, g_over_R = 9.81 / R;
  S sin_psi, cos_psi, sine, cosine;
  bench::sine_and_cosine(q[2], sin_psi, cos_psi);
  bench::sine_and_cosine(q[3], sine, cosine);
  const S p = v[3], w = v[2] * cosine, Q = v[2] * sine, spin = v[4];
  const S s = w + spin;
  const S p_dot = -(Q * (w + 1.2 * spin)) - (0.8 * g_over_R) * cosine;
  const S psi_ddot = 2.0 * p * spin / sine;
  const S pQ = p * Q;
  acceleration[2] = psi_ddot;
  acceleration[3] = p_dot;
  acceleration[4] = (5.0 / 3) * pQ - psi_ddot * cosine;
  const S along = (R / 3) * pQ;
  const S across = R * ((p * p + s * w) * cosine + (p_dot + s * Q) * sine);
  acceleration[0] = along * cos_psi + across * sin_psi;
  acceleration[1] = along * sin_psi - across * cos_psi;
}

}  // namespace by_hand
