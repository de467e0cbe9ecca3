#pragma once

#include <optional>

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Newton steps on the equations f = 0 of implicit holonomic constraints: each is the least displacement in the mass metric
/// along the chosen speeds with (∂f/∂y) δ + f = 0, the problem that Gauss's principle poses for accelerations.
class PositionProjection {
 public:
  /// `moving`: speeds along which the configuration may change. `time`: instead of the symbol t.
  PositionProjection(const Dynamics& dynamics, std::vector<std::size_t> moving, std::optional<ir::Expr> time,
                     ir::Expr epsilon);

  /// There are equations.
  bool has_rows() const { return !rows_.empty(); }

  /// Changes `configuration` by `count` steps; quaternions keep their length.
  void run(int count, Vector& configuration, Steps& steps);

  ir::Expr singular() const { return singular_; }
  ir::Expr dependent() const { return dependent_; }

  /// Boolean: an equation does not hold at `configuration`, which came from `start`.
  ir::Expr violated(const Vector& start, const Vector& configuration) const;

 private:
  /// Square of how large the coordinate of a speed may be taken to be.
  ir::Expr size_of(kinematics::FreeIndex i, const Vector& start, const Vector& configuration) const;
  ir::Expr left_by_all(const Vector& b, const Vector& inertia, ir::Expr size_of_all) const;
  ir::Expr along_coordinate(std::size_t mu, std::size_t i, const Vector& start, const Vector& configuration) const;
  Dynamics problem_at(const Vector& configuration, const std::string& prefix) const;
  void displace(const Vector& change, Vector& configuration) const;
  Vector at(const Vector& expressions, const Vector& configuration, const Vector& speeds) const;
  Vector zeros(std::size_t count) const;

  const Dynamics& dynamics_;
  std::vector<std::size_t> moving_;
  DependentRows dependent_rows_;
  std::optional<ir::Expr> time_;
  ir::Expr epsilon_;
  std::vector<std::size_t> rows_;
  ir::Expr singular_;
  ir::Expr dependent_;
};

}  // namespace gaussgen::strategy
