#pragma once
// Attitude and angular velocity of a rigid body over the chart.

#include "symbolic/chart.hpp"

namespace gaussgen::symbolic {

/// Angular velocity in body axes, in which the inertia is constant.
Vector3 body_angular_velocity(const model::Model& model, const model::Body& body, const Chart& chart);

/// Angular velocity in the axes that make it shortest, for an inertia that is a number in all axes: the middle axes of
/// an Euler sequence, or the quaternion's own frame.
Vector3 shortest_angular_velocity(const model::Body& body, const Chart& chart);

}  // namespace gaussgen::symbolic
