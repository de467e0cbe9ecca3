#pragma once

#include "support/index.hpp"

namespace gaussgen::kinematics {

/// α: a free speed (rate of a free coordinate, or an angular velocity component).
using FreeIndex = support::Index<struct FreeTag>;
/// i: a held coordinate x^i.
using HeldIndex = support::Index<struct HeldTag>;
/// A: all of them, free ones first.
using FullIndex = support::Index<struct FullTag>;
/// μ: a nonholonomic constraint.
using ConstraintIndex = support::Index<struct ConstraintTag>;
/// A body or particle.
using BodyIndex = support::Index<struct BodyTag>;
/// A configuration variable: a free coordinate or a quaternion component.
using ConfigurationIndex = support::Index<struct ConfigurationTag>;

}  // namespace gaussgen::kinematics
