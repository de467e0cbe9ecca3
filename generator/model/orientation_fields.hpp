#pragma once
// Orientations that joints declare. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// A quaternion called after its owner: <owner>_e0 … _e3, <owner>_wx … _wz in the axes that turn. `map` may hold
/// `initial_angular_velocity`. Returns its index.
std::size_t add_orientation(const Name& owner, const spec::Node& map, Reading& reading);

}  // namespace gaussgen::model
