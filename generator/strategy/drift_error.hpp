#pragma once
// Constraints that follow from each other ask for the same accelerations, but for what the state that these are taken at is off by.

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// How far the drift of each constraint of velocities may be off: by rounding of its terms, and since speeds satisfy the constraints no better than rounding
/// or the stages of a step leave them. Of what cancels in the drift, as of a ball that rolls round a cylinder, nothing else tells. Speeds may be off by the
/// least changes, weighed by mass, that satisfy each constraint alone; the drift then is, to first order, by its slopes times these.
/// `off`: square of the part by which positions are off, for each constraint. 0 of derivatives of equations of positions: nobody asks.
Vector drift_errors(const Dynamics& dynamics, const Vector& off, ir::Expr epsilon);

}  // namespace gaussgen::strategy
