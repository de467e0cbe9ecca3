#pragma once
// Where the frames of a model are and how they turn, over a chart.

#include <cstddef>
#include <map>

#include "model/model.hpp"
#include "symbolic/vector.hpp"

namespace gaussgen::symbolic {

class Chart;

struct Placement {
  Vector3 origin;      ///< m, space
  Matrix3 axes;        ///< from components along the frame's axes to those in space
  Vector3 omega_body;  ///< rad/s, along the frame's axes
};

/// Frames are indices into Model::frames.
class Frames {
 public:
  Frames(const model::Model& model, const Chart& chart) : model_(model), chart_(chart) {}

  const Placement& operator()(std::size_t frame) const;

  /// Where a point of the frame is, in space.
  Vector3 point(std::size_t frame, const std::array<model::Ast, 3>& inside) const;

  /// Angular velocity in the axes that make it shortest, for an inertia that is a number in all axes: the middle axes of
  /// an Euler sequence, or the quaternion's own axes, where the frame is placed in space; else along its own axes.
  Vector3 shortest_angular_velocity(std::size_t frame) const;

 private:
  Placement place(std::size_t frame) const;

  const model::Model& model_;
  const Chart& chart_;
  mutable std::map<std::size_t, Placement> placed_;
};

}  // namespace gaussgen::symbolic
