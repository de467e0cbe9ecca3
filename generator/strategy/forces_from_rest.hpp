#pragma once

#include "strategy/tree_choice.hpp"

namespace gaussgen::strategy {

/// The same links without velocities.
kinematics::Linkage at_rest(kinematics::Linkage linkage, ir::Expr zero);

kinematics::Kinematics without_constraints(kinematics::Kinematics kinematics);

/// What forces along the free speeds do to links at rest, without fields and constraints: the accelerations z of G z = Q, in the form of
/// the tree that takes the fewest operations. Nothing where some acceleration has no inertia.
std::optional<Candidate> accelerated_from_rest(const kinematics::Linkage& linkage,
                                               const kinematics::Kinematics& kinematics, const Vector& forces,
                                               ir::Expr epsilon);

}  // namespace gaussgen::strategy
