#pragma once
// The least change of speeds, or of positions along speeds, that satisfies linear equations (see Change).

#include "strategy/tree.hpp"

namespace gaussgen::strategy {

/// Link by link, at a cost that grows with their number: `problem` as it is for accelerations; its velocities and forces are left
/// out. Nothing where `solve_tree` finds nothing.
std::optional<Solution> least_change_of_links(const TreeProblem& problem, const Change& change, ir::Expr epsilon,
                                              Steps& steps);

/// Likewise, or over the metric of these speeds where there are no links, or few operations in it.
Solution least_change(const Dynamics& dynamics, const Change& change, const DependentRows& dependent_rows,
                      ir::Expr epsilon, Steps& steps);

/// The rows of b over some speeds, and g of these, for `change`.
Dynamics over_metric(const Dynamics& dynamics, const Change& change, const DependentRows& dependent_rows,
                     ir::Expr zero);

}  // namespace gaussgen::strategy
