#pragma once
// What the tables of the emitted header say about a value, taken apart for a report.

#include <string>

#include "emit/unit.hpp"

namespace gaussgen {

struct Description {
  std::string unit;   ///< may be empty
  std::string about;  ///< meaning, frame, sign; may be empty
};

/// "[N*m], space axes" in a group "reaction of x" → unit "N*m", about "reaction of x; space axes".
Description describe(const emit::Group& group, const emit::Field& field);

/// Of the generalized force along a coordinate, or a speed, with this unit: N along m or m/s, N*m along rad or rad/s; empty along
/// others.
std::string generalized_unit(const std::string& unit);

/// What an artefact says about itself, on one line.
std::string on_one_line(std::string about);

}  // namespace gaussgen
