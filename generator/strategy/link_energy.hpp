#pragma once

#include "kinematics/linkage.hpp"
#include "strategy/steps.hpp"

namespace gaussgen::strategy {

/// Of all that has mass on links.
struct LinkEnergy {
  ir::Expr kinetic;   ///< J
  ir::Expr of_field;  ///< J, potential in the uniform field
};

/// Velocities and places from the ground outwards, each from those of the link before: the number of operations grows with that of
/// links, where the sum over bodies of what all coordinates do grows with its square. `field`: m/s², space.
LinkEnergy energy_of_links(const kinematics::Linkage& linkage, const ir::Vector3& field, Steps& steps);

}  // namespace gaussgen::strategy
