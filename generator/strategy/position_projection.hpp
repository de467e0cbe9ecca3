#pragma once

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Newton's method on the equations f = 0 of implicit holonomic constraints, at the configuration that symbols stand for: each step is
/// the least displacement in the mass metric along the chosen speeds with (∂f/∂y) δ + f = 0.
class PositionProjection {
 public:
  /// `moving`: speeds along which the configuration may change. `at`: the configuration, with symbols for what changes: what is zero
  /// there says nothing.
  PositionProjection(const Dynamics& dynamics, std::vector<std::size_t> moving, const Vector& at, ir::Expr epsilon);

  /// There are equations.
  bool has_rows() const { return !rows_.empty(); }

  /// The configuration may change such that one of them does.
  bool can_move() const { return !movable_.empty(); }

  /// One step from the configuration that symbols stand for; quaternions keep their length.
  Vector step(Steps& steps);

  /// f, or 0 where that is nothing but rounding of its terms.
  ir::Expr residual(std::size_t mu) const;

  /// Of the equations, those that something moves.
  const std::vector<std::size_t>& movable() const { return movable_; }

  /// The configuration that symbols stand for, displaced along the speeds that may move.
  Vector moved(const Vector& change) const;

  ir::Expr singular() const { return singular_; }
  ir::Expr dependent() const { return dependent_; }

  /// Boolean: an equation does not hold at the configuration that symbols stand for, which came from `start`. Of `start`,
  /// quaternions do not count.
  ir::Expr violated(const Vector& start) const;

 private:
  void displace(const Vector& change, Vector& configuration) const;
  Vector rates_at(const Vector& speeds) const;
  Vector zeros(std::size_t count) const;
  ir::Expr symbol(std::size_t i) const;

  const Dynamics& dynamics_;
  std::vector<std::size_t> moving_;
  DependentRows dependent_rows_;
  ir::Expr epsilon_;
  std::vector<std::size_t> rows_;     ///< constraints with an f
  std::vector<std::size_t> movable_;  ///< those of them that something in `moving` changes
  ir::Expr singular_;
  ir::Expr dependent_;
};

}  // namespace gaussgen::strategy
