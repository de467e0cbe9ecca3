#pragma once
// The chain of rods on universal joints as a person writes it: Newton and Euler rod by rod (the articulated bodies of Featherstone),
// with every zero of these rods and joints left out. Lengths are told in L and masses in m.
//
// Frames: parent, then X, turned by a about x, then B, turned by b about y: the rod, which points along -z of B. What hangs below a
// place needs there, for the angular acceleration α of the parent and the acceleration p of the place, moment and force
//     N = I α + H p + n,   F = Hᵀ α + M p + f.

#include "../counted.hpp"

namespace by_hand::spatial {

inline constexpr double k_mass = 1.3, k_length = 0.7;
inline constexpr double k_g_over_L = 9.81 / k_length;
inline constexpr double k_along =
    0.001 / (k_mass * k_length * k_length);  ///< moment of inertia of a rod about its axis
inline constexpr double k_across = 1.0 / 3;  ///< about its end
inline constexpr double k_half = 0.5;

template <class S>
struct Vector {
  S x, y, z;
};

template <class S>
S dot(const Vector<S>& a, const Vector<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class S>
struct Symmetric {
  S xx, xy, xz, yy, yz, zz;
};

template <class S>
struct Turn {
  S sine, cosine;
};

/// From the axes behind a turn about x to those before it; `back` the other way round.
template <class S>
Vector<S> about_x(const Turn<S>& t, const Vector<S>& v) {
  return {v.x, t.cosine * v.y - t.sine * v.z, t.sine * v.y + t.cosine * v.z};
}
template <class S>
Vector<S> back_about_x(const Turn<S>& t, const Vector<S>& v) {
  return {v.x, t.cosine * v.y + t.sine * v.z, t.cosine * v.z - t.sine * v.y};
}
template <class S>
Vector<S> about_y(const Turn<S>& t, const Vector<S>& v) {
  return {t.cosine * v.x + t.sine * v.z, v.y, t.cosine * v.z - t.sine * v.x};
}
template <class S>
Vector<S> back_about_y(const Turn<S>& t, const Vector<S>& v) {
  return {t.cosine * v.x - t.sine * v.z, v.y, t.sine * v.x + t.cosine * v.z};
}

/// A 2×2 block [[p, q], [q, r]] behind the turn v ← [[c, s], [-s, c]] v.
template <class S>
void turn_block(const Turn<S>& t, S& p, S& q, S& r) {
  const S u = t.sine * (p - r) - t.cosine * (q + q);
  const S change = t.sine * u;
  q = -(t.cosine * u + q);
  p -= change;
  r += change;
}

template <class S>
void turn_about_y(const Turn<S>& t, Symmetric<S>& m) {
  turn_block(t, m.xx, m.xz, m.zz);
  const S xy = t.cosine * m.xy + t.sine * m.yz;
  m.yz = t.cosine * m.yz - t.sine * m.xy;
  m.xy = xy;
}

template <class S>
void turn_about_x(const Turn<S>& t, Symmetric<S>& m) {
  turn_block(t, m.zz, m.yz, m.yy);
  const S xy = t.cosine * m.xy - t.sine * m.xz;
  m.xz = t.sine * m.xy + t.cosine * m.xz;
  m.xy = xy;
}

/// M ← M - h hᵀ/D, with k = h/D.
template <class S>
void subtract(Symmetric<S>& m, const Vector<S>& h, const Vector<S>& k) {
  m.xx -= h.x * k.x;
  m.xy -= h.x * k.y;
  m.xz -= h.x * k.z;
  m.yy -= h.y * k.y;
  m.yz -= h.y * k.z;
  m.zz -= h.z * k.z;
}

template <class S>
Vector<S> minus(const Vector<S>& a, const S& factor, const Vector<S>& b) {
  return {a.x - factor * b.x, a.y - factor * b.y, a.z - factor * b.z};
}

/// What the way forwards needs of a rod: turns, its angular velocities, and each row of a hinge over D.
template <class S>
struct Rod {
  Turn<S> a, b;
  Vector<S> spin;         ///< angular velocity in B
  S spin_y, spin_z;       ///< in X
  Vector<S> tip;          ///< ω × (ω × (0, 0, -1))
  S y_on_x, y_on_z, y_n;  ///< hinge y: rows of I and of n
  Vector<S> y_H;
  S x_on_z, x_n;  ///< hinge x
  Vector<S> x_H;
};

/// What hangs at a place, in the axes before the turn about x of the hinge there. Its moment has one direction, e = (0, -s, c).
template <class S>
struct Hanging {
  Symmetric<S> M;
  S I;          ///< along e
  Vector<S> H;  ///< the row of e
  S n;          ///< along e
  Vector<S> f;
};

template <class S>
void place(const S& a, const S& b, const S& a_dot, const S& b_dot, const Rod<S>* above, Rod<S>& rod) {
  bench::sine_and_cosine(a, rod.a.sine, rod.a.cosine);
  bench::sine_and_cosine(b, rod.b.sine, rod.b.cosine);
  if (above == nullptr) {
    rod.spin = {rod.b.cosine * a_dot, b_dot, rod.b.sine * a_dot};
  } else {
    const Vector<S> spin = back_about_x(rod.a, above->spin);
    rod.spin_y = spin.y;
    rod.spin_z = spin.z;
    rod.spin = back_about_y(rod.b, Vector<S>{spin.x + a_dot, spin.y + b_dot, spin.z});
  }
  const Vector<S>& w = rod.spin;
  rod.tip = {-(w.x * w.z), -(w.y * w.z), w.x * w.x + w.y * w.y};
}

/// Hinge x, in X: rows x and z of I and H are given, those of y are gone. `is_first`: nothing above moves.
template <class S>
Hanging<S> through_x(Rod<S>& rod, const S& a_dot, bool is_first, Symmetric<S> M, const S& I_xx, const S& I_xz,
                     const S& I_zz, const Vector<S>& H_x, const Vector<S>& H_z, S n_x, S n_z, Vector<S> f) {
  Hanging<S> result;
  const S one_over_D = 1.0 / I_xx;
  rod.x_H = {H_x.x * one_over_D, H_x.y * one_over_D, H_x.z * one_over_D};
  if (is_first) {
    rod.x_n = n_x * one_over_D;
    return result;
  }
  // ζ = ω × x a' = a' (0, ω_z, -ω_y); its y meets nothing.
  const S turning = a_dot * rod.spin_y;
  n_x -= I_xz * turning;
  n_z -= I_zz * turning;
  f = minus(f, turning, H_z);
  rod.x_on_z = I_xz * one_over_D;
  rod.x_n = n_x * one_over_D;
  subtract(M, H_x, rod.x_H);
  turn_about_x(rod.a, M);
  result.M = M;
  result.I = I_zz - I_xz * rod.x_on_z;
  result.H = about_x(rod.a, minus(H_z, rod.x_on_z, H_x));
  result.n = n_z - rod.x_on_z * n_x;
  result.f = about_x(rod.a, minus(f, rod.x_n, H_x));
  return result;
}

/// The last rod, of which hinge y leaves little.
template <class S>
Hanging<S> last_rod(Rod<S>& rod, const S& a_dot, const S& b_dot, bool is_first) {
  const Vector<S>& w = rod.spin;
  const S kappa_z = (k_along - k_across) * w.z;
  const S n_y = -(kappa_z * w.x);
  const S bending = b_dot * w.z;
  const S n_x = kappa_z * w.y - k_across * bending, n_z = k_along * b_dot * w.x;
  rod.y_n = n_y * (1.0 / k_across);
  const Vector<S> f = about_y(rod.b, Vector<S>{k_half * rod.tip.x + k_half * rod.y_n,
                                               k_half * rod.tip.y - k_half * bending, k_half * rod.tip.z});
  const Turn<S>& t = rod.b;
  const S square = t.sine * t.sine, product = t.sine * t.cosine;
  const Symmetric<S> M{0.25 + 0.75 * square, 0.0, 0.75 * product, 1.0, 0.0, 1.0 - 0.75 * square};
  constexpr double d = k_along - k_across;
  const Vector<S> H_x{0.0, k_half * t.cosine, 0.0}, H_z{0.0, -k_half * t.sine, 0.0};
  return through_x(rod, a_dot, is_first, M, S(k_across + d * square), S(d * product), S(k_along - d * square), H_x, H_z,
                   S(t.cosine * n_x + t.sine * n_z), S(t.cosine * n_z - t.sine * n_x), f);
}

/// A rod with `below` at its end.
template <class S>
Hanging<S> rod_above(Rod<S>& rod, const Turn<S>& turn_below, const Hanging<S>& below, const S& a_dot, const S& b_dot,
                     bool is_first) {
  const Vector<S>& w = rod.spin;
  const Vector<S>& tip = rod.tip;
  Symmetric<S> M = below.M;
  Vector<S> f{below.f.x + M.xx * tip.x + M.xy * tip.y + M.xz * tip.z,
              below.f.y + M.xy * tip.x + M.yy * tip.y + M.yz * tip.z,
              below.f.z + M.xz * tip.x + M.yz * tip.y + M.zz * tip.z};
  // Along e = (0, -s, c): I e eᵀ, e Hᵀ and e n.
  const S n_e = below.n + dot(below.H, tip);
  const S e_y = -turn_below.sine, e_z = turn_below.cosine;
  const Vector<S> Hy{e_y * below.H.x, e_y * below.H.y, e_y * below.H.z};
  const S I_e_y = below.I * e_y;
  // At the upper end: H + Q M, I + H P + (H P)ᵀ + Q M P, n + Q f, and the rod's own.
  Vector<S> H_x{M.xy, M.yy + k_half, M.yz};
  Vector<S> H_y{Hy.x - M.xx - k_half, Hy.y - M.xy, Hy.z - M.xz};
  Vector<S> H_z{e_z * below.H.x, e_z * below.H.y, e_z * below.H.z};
  const S I_xx = M.yy + k_across;
  S I_xy = Hy.y - M.xy;
  S I_xz = H_z.y;
  const S I_yy = I_e_y * e_y - (Hy.x + Hy.x) + M.xx + k_across;
  S I_yz = I_e_y * e_z - H_z.x;
  const S I_zz = below.I * e_z * e_z + k_along;
  const S kappa_z = (k_along - k_across) * w.z;
  S n_x = f.y + kappa_z * w.y;
  S n_y = e_y * n_e - f.x - kappa_z * w.x;
  S n_z = e_z * n_e;
  f = {f.x + k_half * tip.x, f.y + k_half * tip.y, f.z + k_half * tip.z};
  M.xx += 1.0;
  M.yy += 1.0;
  M.zz += 1.0;

  // ζ = ω × y b' = b' (-ω_z, 0, ω_x)
  const S zeta_x = -(b_dot * w.z), zeta_z = b_dot * w.x;
  n_x += I_xx * zeta_x + I_xz * zeta_z;
  n_y += I_xy * zeta_x + I_yz * zeta_z;
  n_z += I_xz * zeta_x + I_zz * zeta_z;
  f = {f.x + H_x.x * zeta_x + H_z.x * zeta_z, f.y + H_x.y * zeta_x + H_z.y * zeta_z,
       f.z + H_x.z * zeta_x + H_z.z * zeta_z};
  const S one_over_D = 1.0 / I_yy;
  rod.y_on_x = I_xy * one_over_D;
  rod.y_on_z = I_yz * one_over_D;
  rod.y_n = n_y * one_over_D;
  rod.y_H = {H_y.x * one_over_D, H_y.y * one_over_D, H_y.z * one_over_D};
  n_x -= rod.y_on_x * n_y;
  n_z -= rod.y_on_z * n_y;
  S J_xx = I_xx - I_xy * rod.y_on_x, J_xz = I_xz - I_xy * rod.y_on_z, J_zz = I_zz - I_yz * rod.y_on_z;
  H_x = minus(H_x, rod.y_on_x, H_y);
  H_z = minus(H_z, rod.y_on_z, H_y);
  f = minus(f, rod.y_n, H_y);

  const Turn<S>& t = rod.b;
  turn_block(t, J_xx, J_xz, J_zz);
  const Vector<S> G_x = about_y(t, H_x), G_z = about_y(t, H_z);
  const Vector<S> X_x{t.cosine * G_x.x + t.sine * G_z.x, t.cosine * G_x.y + t.sine * G_z.y,
                      t.cosine * G_x.z + t.sine * G_z.z};
  const Vector<S> X_z{t.cosine * G_z.x - t.sine * G_x.x, t.cosine * G_z.y - t.sine * G_x.y,
                      t.cosine * G_z.z - t.sine * G_x.z};
  if (!is_first) {
    subtract(M, H_y, rod.y_H);
    turn_about_y(t, M);
    f = about_y(t, f);
  }
  return through_x(rod, a_dot, is_first, M, J_xx, J_xz, J_zz, X_x, X_z, S(t.cosine * n_x + t.sine * n_z),
                   S(t.cosine * n_z - t.sine * n_x), f);
}

/// q and v: a and b of each rod.
template <int n, class S>
void spatial_chain(const S* q, const S* v, S* acceleration) {
  Rod<S> rods[n];
  for (int i = 0; i < n; ++i)
    place(q[2 * i], q[2 * i + 1], v[2 * i], v[2 * i + 1], i == 0 ? nullptr : &rods[i - 1], rods[i]);
  Hanging<S> below = last_rod(rods[n - 1], v[2 * n - 2], v[2 * n - 1], n == 1);
  for (int i = n - 2; i >= 0; --i) below = rod_above(rods[i], rods[i + 1].a, below, v[2 * i], v[2 * i + 1], i == 0);

  // α of the rod above and p of the place, first in its axes, then in X, then in B. What ζ does to the moments stands in n already.
  Vector<S> alpha, p;
  for (int i = 0; i < n; ++i) {
    const Rod<S>& rod = rods[i];
    const S& a_dot = v[2 * i];
    const S& b_dot = v[2 * i + 1];
    S a;
    if (i == 0) {
      const S up_y = rod.a.sine * k_g_over_L, up_z = rod.a.cosine * k_g_over_L;
      a = -(rod.x_H.y * up_y + rod.x_H.z * up_z + rod.x_n);
      p = {-(rod.b.sine * up_z), up_y, rod.b.cosine * up_z};
      alpha = {rod.b.cosine * a, 0.0, rod.b.sine * a};
    } else {
      alpha = back_about_x(rod.a, alpha);
      p = back_about_x(rod.a, p);
      a = -(alpha.x + rod.x_on_z * alpha.z + dot(rod.x_H, p) + rod.x_n);
      p = back_about_y(rod.b, p);
      alpha = back_about_y(rod.b, Vector<S>{alpha.x + a, alpha.y + a_dot * rod.spin_z, alpha.z - a_dot * rod.spin_y});
    }
    acceleration[2 * i] = a;
    if (i == n - 1) {
      acceleration[2 * i + 1] = i == 0 ? 1.5 * p.x - rod.y_n : 1.5 * p.x - alpha.y - rod.y_n;
      break;
    }
    S turn_y = -(rod.y_on_x * alpha.x + rod.y_on_z * alpha.z + dot(rod.y_H, p) + rod.y_n);
    acceleration[2 * i + 1] = i == 0 ? turn_y : turn_y - alpha.y;
    alpha = {alpha.x - b_dot * rod.spin.z, turn_y, alpha.z + b_dot * rod.spin.x};
    p = {p.x - alpha.y + rod.tip.x, p.y + alpha.x + rod.tip.y, p.z + rod.tip.z};
  }
}

}  // namespace by_hand::spatial
