#pragma once
// Where forces lead a model that is let go at rest, step by step, until they are in balance.

#include "dense.hpp"

namespace gaussgen {

/// A place at which it is not at rest, n speeds.
struct RestForces {
  Eigen::VectorXd force;      ///< n: f + bᵀ λ, along the speeds
  Eigen::MatrixXd stiffness;  ///< n x n: how it becomes less along displacements
  Eigen::MatrixXd metric;     ///< n x n
  Eigen::MatrixXd rows;       ///< of n: b of each constraint that no way leads across
};

class RestSlope {
 public:
  explicit RestSlope(const RestForces& here);

  /// Every way leads uphill or nowhere: whoever is let go near by comes here.
  bool is_bottom() const;

  /// Along each mode as far as its force goes with its stiffness, but downhill also where this is negative, and never farther than
  /// `longest` along any speed. [Greenstadt: Math. Comp. 21 (1967) 360-367]
  Eigen::VectorXd downhill(const Eigen::VectorXd& longest) const;

 private:
  Eigen::VectorXd stiffness_;  ///< of modes, per mass
  Eigen::MatrixXd shapes_;     ///< of unit mass, which constraints allow
  Eigen::VectorXd force_;      ///< on modes
};

}  // namespace gaussgen
