#pragma once
// What each effect of a scene costs and changes, and in which order they are left out best.

#include <optional>
#include <vector>

#include "sim/effects/workbench.hpp"

namespace gausssim {

struct Compared {
  Move move;  ///< of the first rung none, but a name
  Measured measured;
};

struct Ladder {
  Measured all, none;          ///< none: of choices of one among several, that of `all`
  std::vector<Compared> each;  ///< all of them but one
  /// Each leaves out one more than the one before it: that whose absence changes the motion least from that with all. None takes more
  /// operations than the one before it.
  std::vector<Compared> rungs;

  /// Operations of `all` that nothing in `each` saves by itself, and that are not in `none`: several effects share them. Below 0 where effects
  /// are in each other's way.
  int shared_operations() const;
};

/// Of the sets that were run: the fewest operations, then the fewest effects, of which the motion changes by no more. `all` is one of them.
Measured cheapest_within(const Ladder& ladder, double change);

/// Nothing: it was interrupted, or its time is over.
std::optional<Ladder> make_ladder(Workbench& bench);

}  // namespace gausssim
