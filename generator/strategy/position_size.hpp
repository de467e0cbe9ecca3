#pragma once
// How large what equations of positions are made of is: what is left of them counts beside it.

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Square of what rounding of all coordinates or speeds, weighed by mass, may leave of a constraint with this row: with sum I_i d_i^2 = eps^2 `size_of_all`
/// it is at most eps^2 `size_of_all` sum b_i^2 / I_i, in whatever units. A height of 0 beside others is as good as 1e-50, and so is the speed of what stands
/// still. `size_of_all` is the sum of their squares times inertias; what has no inertia does not count.
ir::Expr left_by_all(const Vector& b, const Vector& inertia, ir::Expr size_of_all, ir::Expr epsilon);

/// At the configuration that symbols stand for, which came from `start`; of `start`, quaternions do not count. Squares, since conditions and sums of them have
/// no sign. Angles count as 1 besides their size, since they may have gone anywhere.
class PositionSize {
 public:
  PositionSize(const Dynamics& dynamics, const Vector& start) : dynamics_(dynamics), start_(start) {}

  /// Of the coordinate of a speed.
  ir::Expr of_speed(kinematics::FreeIndex i) const;

  /// Of the equation of this constraint, to first order.
  ir::Expr of_row(std::size_t mu) const;

 private:
  ir::Expr along_coordinate(std::size_t mu, std::size_t i) const;
  ir::Expr symbol(std::size_t i) const;
  ir::Expr number(int value) const;

  const Dynamics& dynamics_;
  const Vector& start_;
};

}  // namespace gaussgen::strategy
