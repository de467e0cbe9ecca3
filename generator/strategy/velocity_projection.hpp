#pragma once

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// φ, b and g at one state; or b a + its drift, for accelerations.
struct VelocityProblem {
  Vector phi;
  Matrix b;
  std::optional<Matrix> g;  ///< nothing: at the configuration that symbols stand for, where links are known as well
};

/// Newton steps on φ(u) = 0 over some of the speeds: each is the least δu in the metric g with b δu + φ = 0, which is the
/// problem that Gauss's principle poses for accelerations, without forces.
class VelocityProjection {
 public:
  VelocityProjection(const Dynamics& dynamics, std::vector<std::size_t> moving, ir::Expr epsilon);

  /// Changes `speeds` by one step at `at`, by the rows that are `movable`.
  void step(const VelocityProblem& at, const std::vector<std::size_t>& movable, const std::string& prefix,
            Vector& speeds, Steps& steps);

  /// Rows that something in `moving` changes.
  std::vector<std::size_t> movable(const VelocityProblem& at) const;

  /// One step satisfies a linear constraint exactly, unless none of its speeds is free to move.
  std::vector<std::size_t> to_be_checked(const std::vector<std::size_t>& movable) const;

  ir::Expr singular() const { return singular_; }
  ir::Expr dependent() const { return dependent_; }

 private:
  Solution change(const VelocityProblem& at, const std::vector<std::size_t>& movable, const std::string& prefix,
                  Steps& steps) const;
  ir::Expr lost(const VelocityProblem& at, const std::vector<std::size_t>& movable) const;

  const Dynamics& dynamics_;
  std::vector<std::size_t> moving_;
  DependentRows dependent_rows_;
  ir::Expr epsilon_;
  ir::Expr singular_;
  ir::Expr dependent_;
};

/// Boolean: φ is not zero beside the terms of its linear part, which are of these sizes for speeds of 1: where Newton's method has converged nothing is
/// left but rounding, and where it has not, φ is large. `part` of the squares of these terms may be left of φ², and `left` of each row.
ir::Expr violated(const VelocityProblem& at, const Matrix& sizes, const Vector& speeds,
                  const std::vector<std::size_t>& rows, ir::Expr part, const Vector& left);

}  // namespace gaussgen::strategy
