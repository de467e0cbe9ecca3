#pragma once
// What is the same all around its axis, such as a wheel: its axes need not turn with it.

#include <functional>

#include "strategy/mass_properties.hpp"

namespace gaussgen::strategy {

/// Turns about an axis of symmetry of all that they carry become spins. One that follows turns about the same axis hangs where
/// these begin. Places on a spin are given in its axes, which stay.
void find_spins(const std::vector<MassProperties>& properties, kinematics::Linkage& linkage);

/// Lets the axes of a spin follow a place that wanders around it at a fixed distance from the axis, as that where a wheel touches.
void follow(kinematics::Linkage& linkage, std::size_t spin, const ir::Vector3& place,
            const std::function<ir::Expr(ir::Expr)>& rate_of);

}  // namespace gaussgen::strategy
