#pragma once
// The step of Newton's method on equations of which some follow from others at the solution and not beside it, as those of closed loops in space.

#include <cmath>
#include <limits>

#include "dense.hpp"

namespace gaussgen {

/// Sine of the angle to all rows before, below which a row says nothing of its own to a step: rank_of_steps of gauss/constrained.hpp.
inline const double k_least_sine_of_step = 4 * std::sqrt(std::numeric_limits<double>::epsilon());

/// Likewise of a row beyond the usual rank.
inline constexpr double k_least_sine_beyond = 0.05;

inline constexpr Eigen::Index k_unknown_rank = std::numeric_limits<Eigen::Index>::max();

/// Of the displacements δ that leave the least of b δ + f, rows of unit length, that with the least δᵀ g δ. Rows count as independent by the sine of their
/// angle where inertias are 1: beside a solution those that follow from others there are as far from them as the position is from the solution, and what
/// they ask for beyond the others is an error of second order; to a direction that only rounding tells from these no step is taken. Beyond the `usual` rank, if it
/// is known, a row has to be farther from the others than a position beside a solution makes it, or it moves the position along the motion.
Eigen::VectorXd least_step(const Eigen::MatrixXd& g, const Eigen::MatrixXd& b, const Eigen::VectorXd& f,
                           double least_sine = k_least_sine_of_step, Eigen::Index usual = k_unknown_rank);

}  // namespace gaussgen
