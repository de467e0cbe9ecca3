#pragma once

#include "kinematics/expressions.hpp"

namespace gaussgen::kinematics {

/// Of the point of a frame that is at `place` now, against space: v + ω × r.
ir::Vector3 velocity_at(Expressions& expressions, std::size_t frame, const ir::Vector3& place);

/// How fast the points of two bodies that are at one place now slip along a direction, times the length of that.
/// The difference of two velocities is the same seen from any frame: it is formed in space or in the axes in which the direction is
/// given, whichever takes fewer operations. `place` and `direction` are those of the law in space.
ir::Expr slip(Expressions& expressions, const model::SlipLaw& law, const ir::Vector3& place,
              const ir::Vector3& direction);

}  // namespace gaussgen::kinematics
