#pragma once
// The step of Newton's method on equations of which some follow from others at the solution and not beside it, as those of closed loops in space.

#include <cmath>
#include <limits>
#include <vector>

#include "dense.hpp"

namespace gaussgen {

/// Sine of the angle to all rows before, below which a row says nothing of its own to a step: rank_of_steps of gauss/constrained.hpp.
inline const double k_least_sine_of_step = 4 * std::sqrt(std::numeric_limits<double>::epsilon());

/// speed_scales of these rows.
Eigen::VectorXd scales_of_columns(const std::vector<double>& inertias, const Eigen::MatrixXd& b);

/// Of the displacements δ that leave the least of b δ + f, rows of unit length, that with the least δᵀ g δ. Rows count as independent by the sine of their
/// angle where inertias are 1: beside a solution those that follow from others there are as far from them as the position is from the solution, and what
/// they ask for beyond the others is an error of second order; to a direction that only rounding tells from these no step is taken.
Eigen::VectorXd least_step(const Eigen::MatrixXd& g, const Eigen::MatrixXd& b, const Eigen::VectorXd& f,
                           double least_sine = k_least_sine_of_step);

/// The step of emitted code: no more rows than the `usual` rank, at each time the one that is farthest from those before, and these exactly: beyond it a row
/// would move the position along the motion. Of rows that are as far, as at first all are, only rounding tells there which is next; here `preferred` is, or the first one.
Eigen::VectorXd emitted_step(const Eigen::MatrixXd& g, const Eigen::MatrixXd& b, const Eigen::VectorXd& f,
                             double least_sine, Eigen::Index usual, Eigen::Index preferred = 0);

}  // namespace gaussgen
