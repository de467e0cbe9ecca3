#pragma once

#include "kinematics/expressions.hpp"

namespace gaussgen::kinematics {

/// Of the point of a frame that is at `place` now, against space: v + ω × r.
ir::Vector3 velocity_at(Expressions& expressions, std::size_t frame, const ir::Vector3& place);

/// Where two bodies slip on each other, and along what, in space.
struct ContactLine {
  ir::Vector3 point, direction;
};

ContactLine contact_line(Expressions& expressions, const model::SlipLaw& law);

/// How fast the points of two bodies that are at one place now slip along a direction, times the length of that.
/// The difference of two velocities is the same seen from any frame: it is formed in space or in the axes in which the direction is
/// given, whichever takes fewer operations. `line` is that of the law.
ir::Expr slip(Expressions& expressions, const model::SlipLaw& law, const ContactLine& line);

}  // namespace gaussgen::kinematics
