#pragma once

#include <string>

namespace gausssim {

/// What happened at an instant of a motion.
struct Event {
  double t = 0;
  std::string what;    ///< floor hits; friction slides
  double impulse = 0;  ///< along the gap, where it is an impact
};

}  // namespace gausssim
