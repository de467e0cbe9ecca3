#pragma once
// Wheels, discs and balls: what a body looks like that touches something at places which wander over it.

#include <optional>
#include <vector>

#include "sim/study/motion.hpp"

namespace gausssim {

/// A disc where places of contact are on a circle around the mass centre, a ball where they go further.
struct RoundBody {
  double radius = 0;
  std::optional<Place> axis;  ///< of a disc, in axes of the body
};

/// Nothing where the contact stays on one place of the body, or is not always as far from the mass centre, up to `rounding`.
std::optional<RoundBody> round_body(const Motion::Body& body, const std::vector<Place>& contact, double rounding);

}  // namespace gausssim
