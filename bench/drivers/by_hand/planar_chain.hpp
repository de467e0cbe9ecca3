#pragma once
// The planar chain as a person writes it: n uniform rods that hang from each other, relative angles. Lengths are told in L and
// masses in m, so that no other constant is left than g/L.
//
// Rod i has the angle θ against the vertical, t is the direction in which its lower end goes as it turns, u points along it, and a is
// the acceleration of its upper end (gravity is an acceleration of the pivot upwards).

#include <cmath>

#include "../counted.hpp"

namespace by_hand {

inline constexpr double k_rod_length = 0.7;
inline constexpr double k_g_over_L = 9.81 / k_rod_length;

/// Newton and Euler rod by rod. What hangs below a place that is accelerated by a needs the force (ν - 1/2) a + b there; of a rod with
/// something below
///     w = ν t,   D = w·t - 1/6,   y = ω² u,   c = b - ν y,   k = t·c,
///     angular acceleration -(w·a + k)/D,   ν ← ν + 1 - w wᵀ/D,   b ← c - w k/D.
template <int n, class S>
void planar_chain(const S* q, const S* v, S* acceleration) {
  static_assert(n > 1);
  S cosine[n], sine[n], y0[n], y1[n], wD0[n], wD1[n], kD[n];
  S angle = q[0], rate = v[0];
#pragma GCC unroll 64
  for (int i = 0; i < n; ++i) {
    if (i > 0) {
      angle += q[i];
      rate += v[i];
    }
    bench::sine_and_cosine(angle, sine[i], cosine[i]);
    const S square = rate * rate;
    y0[i] = square * sine[i];
    y1[i] = -(square * cosine[i]);
  }
  // The last rod: ν = 1/2, D = 1/3, k = 0, and nothing below.
  constexpr int last = n - 1;
  wD0[last] = 1.5 * cosine[last];
  wD1[last] = 1.5 * sine[last];
  S v00 = 1.5 - 0.5 * cosine[last] * wD0[last];
  S v01 = -(0.5 * sine[last] * wD0[last]);
  S v11 = 1.5 - 0.5 * sine[last] * wD1[last];
  S b0 = -(0.5 * y0[last]), b1 = -(0.5 * y1[last]);
#pragma GCC unroll 64
  for (int i = last - 1; i >= 0; --i) {
    const S t0 = cosine[i], t1 = sine[i];
    const S w0 = v00 * t0 + v01 * t1, w1 = v01 * t0 + v11 * t1;
    const S one_over_D = 1.0 / (w0 * t0 + w1 * t1 - 1.0 / 6);
    wD0[i] = w0 * one_over_D;
    wD1[i] = w1 * one_over_D;
    const S c0 = b0 - (v00 * y0[i] + v01 * y1[i]), c1 = b1 - (v01 * y0[i] + v11 * y1[i]);
    kD[i] = (t0 * c0 + t1 * c1) * one_over_D;
    if (i == 0) break;
    b0 = c0 - w0 * kD[i];
    b1 = c1 - w1 * kD[i];
    v00 = v00 - w0 * wD0[i] + 1.0;
    v01 = v01 - w0 * wD1[i];
    v11 = v11 - w1 * wD1[i] + 1.0;
  }
  S turn = -(wD1[0] * k_g_over_L + kD[0]);
  acceleration[0] = turn;
  S a0 = turn * cosine[0] - y0[0], a1 = k_g_over_L + turn * sine[0] - y1[0];
#pragma GCC unroll 64
  for (int i = 1; i < last; ++i) {
    const S former = turn;
    turn = -(wD0[i] * a0 + wD1[i] * a1 + kD[i]);
    acceleration[i] = turn - former;
    a0 = a0 + turn * cosine[i] - y0[i];
    a1 = a1 + turn * sine[i] - y1[i];
  }
  acceleration[last] = -(wD0[last] * a0 + wD1[last] * a1) - turn;
}

/// One rod is a pendulum, and two are written by their own equations: -(F_1, F_2)/2 are the forces in absolute angles.
template <int n, class S>
void planar_chain_closed(const S* q, const S* v, S* acceleration) {
  using std::sin;
  static_assert(n <= 2);
  if constexpr (n == 1) {
    acceleration[0] = -(1.5 * k_g_over_L) * sin(q[0]);
  } else {
    S sine, cosine;
    bench::sine_and_cosine(q[1], sine, cosine);
    const S rate = v[0] + v[1];
    const S F1 = sine * (rate * rate) - (3 * k_g_over_L) * sin(q[0]);
    const S F2 = sine * (v[0] * v[0]) + k_g_over_L * sin(S(q[0] + q[1]));
    const S c = 3.0 * cosine;
    const S one_over = 1.0 / (16.0 / 3 - c * cosine);
    const S first = (2.0 * F1 + c * F2) * one_over;
    acceleration[0] = first;
    acceleration[1] = -((8.0 * F2 + c * F1) * one_over) - first;
  }
}

/// The same by the equations in absolute angles, whose matrix is full: M_jj = 1/3 + below, M_ij = (1/2 + below) cos(θ_i - θ_j), where
/// `below` are the rods that hang from the lower of the two.
template <int n, class S>
void planar_chain_dense(const S* q, const S* v, S* acceleration) {
  S sine[n], cosine[n], square[n], M[n][n], f[n];
  S angle = q[0], rate = v[0];
  for (int i = 0; i < n; ++i) {
    if (i > 0) {
      angle += q[i];
      rate += v[i];
    }
    bench::sine_and_cosine(angle, sine[i], cosine[i]);
    square[i] = rate * rate;
    f[i] = -(k_g_over_L * (n - i - 0.5)) * sine[i];
  }
  for (int j = 0; j < n; ++j) {
    const double k = n - j - 0.5;
    M[j][j] = 1.0 / 3 + (n - 1 - j);
    for (int i = 0; i < j; ++i) {
      M[j][i] = k * (cosine[i] * cosine[j] + sine[i] * sine[j]);
      const S x = k * (sine[i] * cosine[j] - cosine[i] * sine[j]);
      f[i] -= x * square[j];
      f[j] += x * square[i];
    }
  }
  // L D Lᵀ; the diagonal keeps 1/D.
  for (int j = 0; j < n; ++j) {
    S column[n];
    for (int i = 0; i < j; ++i) {
      S sum = M[j][i];
      for (int k = 0; k < i; ++k) sum -= M[i][k] * column[k];
      column[i] = sum;
    }
    S pivot = M[j][j];
    for (int i = 0; i < j; ++i) {
      M[j][i] = column[i] * M[i][i];
      pivot -= M[j][i] * column[i];
      f[j] -= M[j][i] * f[i];
    }
    M[j][j] = 1.0 / pivot;
  }
  for (int i = n - 1; i >= 0; --i) {
    S sum = f[i] * M[i][i];
    for (int k = i + 1; k < n; ++k) sum -= M[k][i] * f[k];
    f[i] = sum;
  }
  acceleration[0] = f[0];
  for (int i = 1; i < n; ++i) acceleration[i] = f[i] - f[i - 1];
}

}  // namespace by_hand
