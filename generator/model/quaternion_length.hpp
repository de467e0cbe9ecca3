#pragma once
// Initial quaternions: they are divided by their length, which should be 1 already.

#include <optional>

#include "model/evaluate.hpp"
#include "model/model.hpp"

namespace gaussgen::model {

/// Of the initial quaternion; nothing where a component has no known value.
std::optional<double> initial_length(const Orientation& orientation, const Values& values);

/// Whether rounding of the components to three digits explains that it is not 1.
bool is_length_of_rotation(double length);

}  // namespace gaussgen::model
