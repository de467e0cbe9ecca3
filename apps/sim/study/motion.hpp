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
    enum class Shape { unknown, disc, ball };

    std::string name;
    std::vector<Place> position;  ///< of the mass centre [m], space axes
    std::vector<std::array<double, 4>>
        orientation;  ///< w, x, y, z: from axes of the body to those of space; empty: a particle
    Shape shape = Shape::unknown;
    double radius = 0;  ///< of discs, which lie around z of `orientation`, and of balls [m]
  };
  struct Line {
    std::string name;
    std::vector<std::vector<Place>> points;
  };
  struct Force {
    std::string name, body, unit;
    std::vector<Place> at, force;  ///< on the body, space axes
  };

  std::optional<Place> up;  ///< against gravity, of length 1; nothing where there is none
  double edge = 0;          ///< of bodies, none of which says how large it is [m]; 0: nothing has a size here
  std::vector<double> t;
  std::vector<Body> bodies;
  std::vector<Line> lines;
  std::vector<Force> forces;
};

/// A run of the model by `setting`, for its output `poses`; nothing where it has none.
std::optional<Motion> motion_of(const PreparedModel& model, const Engine& engine, const Setting& setting);

}  // namespace gausssim
