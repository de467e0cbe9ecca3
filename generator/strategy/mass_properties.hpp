#pragma once
// Mass, mass centre and inertia of what moves with each link.

#include "kinematics/linkage.hpp"
#include "strategy/ldl.hpp"

namespace gaussgen::strategy {

/// About the origin of a link, in its axes.
struct MassProperties {
  ir::Expr mass;
  ir::Vector3 first;    ///< mass times the mass centre
  ir::Matrix3 inertia;  ///< about the origin
};

bool has_nothing(const MassProperties& own);

/// Of the parts on each link, parallel to the links.
std::vector<MassProperties> mass_properties(const kinematics::Linkage& linkage, ir::Graph& graph);

/// A mass at an origin weighs the same with either of two links that share this origin. Counted such that a bar is a moment of
/// inertia and two masses at its ends, the masses need no rotation, and the Schur complements at its ends become products.
/// Left as it is where these masses would be far larger than those of the bar, and cancel. A particle at such an end goes with what hangs there.
/// Returns, for each link, the mass that belongs to the link before.
Vector move_masses_to_ends(const std::vector<kinematics::Link>& links, std::vector<MassProperties>& properties);

}  // namespace gaussgen::strategy
