#pragma once
// The motion of the ball, drawn: `./run demo --svg FILE`.

#include <string>

#include "run.hpp"

namespace sphere {

/// An SVG of a run: the way of the ball with the force of the wall, and both over time, beside the closed form.
std::string picture_of(const Run& run, const ClosedForm& exact);

}  // namespace sphere
