#pragma once
// How frames turn, as far as the model says it in so many words.

#include "model/model.hpp"

namespace gaussgen::model {

/// Whether all turns between a frame and space are about the same one of its axes x, y, z, or there are none: so it is in a planar
/// mechanism. False where it cannot be read off, as with a quaternion or an oblique axis.
bool turns_about_one_own_axis(const Model& model, std::size_t frame);

/// The name of what an orientation is against: "space" or a frame, the parent of those that are turned by it; "parent" where these have several.
std::string outer_frame(const Model& model, std::size_t orientation);

}  // namespace gaussgen::model
