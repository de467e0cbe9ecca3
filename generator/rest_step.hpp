#pragma once
// One step towards a position of rest: in what units its unknowns are measured, and which ways it may take.

#include "dense.hpp"

namespace gaussgen {

/// n displacements along speeds come first, then multipliers.
struct RestUnknowns {
  Eigen::VectorXd effects;  ///< of each: the size of what it changes
  Eigen::VectorXd masses;   ///< n: g_αα
  Eigen::MatrixXd held;     ///< rows of n: ∂φ/∂u of constraints that no way leads across
};

/// Orthonormal columns: the changes that rows of constraints leave open.
Eigen::MatrixXd open_ways(const Eigen::MatrixXd& rows);

class RestStep {
 public:
  /// The equations, linearised, in units of their sizes.
  RestStep(const Eigen::MatrixXd& matrix, const RestUnknowns& unknowns);

  /// The least change with matrix * change = right, in which less than `rank` of the largest pivot counts as nothing.
  Eigen::VectorXd least(const Eigen::VectorXd& right, double rank) const;

  /// Least |matrix * change - right|² + damping |change|²: with a damping like the square of `right` it ends near where it began,
  /// also where equilibria lie side by side and Newton's method runs along them. [Yamashita, Fukushima: Computing Suppl. 15 (2001)
  /// 239-249]
  Eigen::VectorXd damped(const Eigen::VectorXd& right, double damping) const;

 private:
  // Of unknowns in units of their sizes: change = ways * z.
  Eigen::MatrixXd ways_;
  Eigen::MatrixXd matrix_;
};

}  // namespace gaussgen
