#pragma once
// `orientation:` of a body, a frame or a fixed joint. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// The name of an orientation, {euler: zxz, angles: [...]}, or {axis: z, angle: psi}.
Attitude read_attitude(const spec::Entry& entry, Reading& reading);

/// x, y, z, or three components over parameters; `where` names the key in messages.
/// An error for a direction that is none.
void refuse_zero_axis(support::Span span, Reading& reading);

std::variant<char, std::array<Ast, 3>> read_axis(const spec::Node& node, support::Span owner, const std::string& where,
                                                 Reading& reading);

/// The orientation that is called so; one that does not exist is reported.
QuaternionOrientation find_orientation(const spec::Node& scalar, Reading& reading);

}  // namespace gaussgen::model
