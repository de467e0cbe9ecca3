#pragma once
// States of models/bicycle.yaml, and SymPy's words for them. There z points upwards and y to the left, so lean and steer have our
// sign and all else has the other; where the bicycle is does not occur.

#include "contender.hpp"

namespace bench::bicycle {

/// By bench/harness/bicycle_states.py: x, y, z, yaw, lean, pitch, steer, rear_turn, front_turn and their rates.
inline constexpr double k_known[][18] = {
#include "bicycle_states.inc"
};

enum { x, y, z, yaw, lean, pitch, steer, rear_turn, front_turn };

inline Sample sample(std::size_t i) {
  const double* const known = k_known[i % (sizeof k_known / sizeof k_known[0])];
  return {{known, known + 9}, {known + 9, known + 18}};
}

/// yaw, lean, steer, pitch; rates of lean, rear wheel, steer, yaw, pitch, front wheel.
inline void to_sympy(const Sample& s, double* state) {
  const double values[] = {-s.q[yaw],       s.q[lean],  s.q[steer], -s.q[pitch], s.v[lean],
                           -s.v[rear_turn], s.v[steer], -s.v[yaw],  -s.v[pitch], -s.v[front_turn]};
  for (std::size_t i = 0; i < 10; ++i) state[i] = values[i];
}

inline void from_sympy(const double* u_dot, double* a) {
  a[x] = a[y] = a[z] = k_not_given;
  a[lean] = u_dot[0];
  a[rear_turn] = -u_dot[1];
  a[steer] = u_dot[2];
  a[yaw] = -u_dot[3];
  a[pitch] = -u_dot[4];
  a[front_turn] = -u_dot[5];
}

}  // namespace bench::bicycle
