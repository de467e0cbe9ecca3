#include "registry.hpp"

namespace hard_cases {

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"H01", "Euler angles at their pole: a rolling ball", euler_pole},
      {"H12", "A pendulum swings for very long", long_run},
      {"H13", "Constraints drift: a pendulum in Cartesian coordinates", constraint_drift},
      {"H14", "Time adds up", accumulated_time},
      {"H20", "A pivot that shakes by a law in time", moving_pivot},
      {"H28", "Out and back in time", time_reversal},
      {"H30", "A start that violates the constraints", ill_start},
  };
  return all;
}

}  // namespace hard_cases
