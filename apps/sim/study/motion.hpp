#pragma once
// The motion itself, to be looked at: where bodies are, what holds them together, and the forces of constraints.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/simulate.hpp"

namespace gausssim {

using Place = std::array<double, 3>;

/// All lists have an entry for each time.
struct Motion {
  struct Body {
    std::string name;
    std::vector<Place> position;  ///< of the mass centre [m], space axes
    std::vector<std::array<double, 4>>
        orientation;  ///< w, x, y, z: from axes of the body to those of space; empty: a particle
  };
  struct Line {
    std::string name;
    std::vector<std::vector<Place>> points;
  };
  struct Force {
    std::string name, body, unit;
    std::vector<Place> at, force;  ///< on the body, space axes
  };

  double size = 0;  ///< of the room that it takes [m]
  std::vector<double> t;
  std::vector<Body> bodies;
  std::vector<Line> lines;
  std::vector<Force> forces;
};

/// A run of the model by `setting`, for its output `poses`; nothing where it has none.
std::optional<Motion> motion_of(const PreparedModel& model, const Engine& engine, const Setting& setting);

}  // namespace gausssim
