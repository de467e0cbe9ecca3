#pragma once

#include <vector>

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Where coordinates release their bodies completely. Only there do the covariant components of a reaction determine a force
/// and a moment on each body (theory section 4: Z knows the part of a constraint force inside E_{n+k} and no more).
///
/// Coordinates and bodies fall into groups that share nothing. A group is released when it has as many coordinates as its
/// bodies have freedoms: 3 for a particle, 6 for a rigid body, fewer where the whole group stays in one plane or on one line.
/// A cart on a rail that carries a bob in a plane is not released: the rod also presses the cart onto the rail, which no
/// coordinate of the cart can tell.
class Release {
 public:
  explicit Release(const Dynamics& dynamics);

  bool is_released(kinematics::FullIndex i) const { return released_[i.value] != 0; }

  /// All released coordinates, in order.
  std::vector<std::size_t> released() const;

 private:
  std::vector<char> released_;
};

/// Whether G over these has an inverse: not where some do the same, as x and y in [x + y, 2*(x + y), z].
bool is_invertible(const Dynamics& dynamics, const std::vector<std::size_t>& coordinates);

}  // namespace gaussgen::strategy
