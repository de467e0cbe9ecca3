#include "registry.hpp"

namespace hard_cases {

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"H10", "A fast spin", fast_spin},
      {"H11", "An angle grows without end", angle_growth},
      {"H12", "A pendulum swings for very long", long_run},
      {"H13", "Constraints drift: a pendulum in Cartesian coordinates", constraint_drift},
      {"H14", "Time adds up", accumulated_time},
#ifdef GAUSS_HAS_SUNDIALS
      {"H15", "Stiff: fast rates beside a slow motion", stiff},
#endif
      {"H20", "A pivot that shakes by a law in time", moving_pivot},
      {"H28", "Out and back in time", time_reversal},
      {"H30", "A start that violates the constraints", ill_start},
  };
  return all;
}

}  // namespace hard_cases
