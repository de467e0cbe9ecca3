#pragma once

#include "kinematics/expressions.hpp"

namespace gaussgen::kinematics {

/// Orientation of a body: `matrix` maps body components to space components, ω is given in `frame`.
struct Rotation {
  ir::Matrix3 matrix;
  ir::Vector3 omega;
  model::Frame frame = model::Frame::space;
};

/// The orientation of `body` (it must have one) with ω resolved in `frame`.
Rotation rotation_of(const model::Model& model, const model::Body& body, const Symbols& symbols, model::Frame frame,
                     Expressions& expressions);

}  // namespace gaussgen::kinematics
