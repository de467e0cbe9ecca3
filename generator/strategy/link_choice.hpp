#pragma once
// Reactions follow from the accelerations of links, or from those along the speeds: whichever takes fewer operations.

#include <utility>

#include "strategy/accelerations.hpp"
#include "strategy/tree_motion.hpp"

namespace gaussgen::strategy {

/// Of these values and of the solution that they follow from, each counted once.
int operations_with(const Solution& solution, const Vector& values);

/// `by_links` (which may have nothing) and `by_speeds` give a Result and its steps, `values_of` what of it is emitted. Over speeds
/// nothing is formed where many of them move a body: it is longer there.
template <class Result, class ByLinks, class BySpeeds, class ValuesOf>
Result by_links_or_speeds(const Solution& solution, ByLinks by_links, BySpeeds by_speeds, ValuesOf values_of,
                          Steps& steps) {
  Steps along_links, over_speeds;
  std::optional<Result> links = by_links(along_links);
  if (links && !are_moved_by_few_speeds(*solution.motion)) {
    steps.append(along_links);
    return std::move(*links);
  }
  Result speeds = by_speeds(over_speeds);
  const bool takes_links =
      links && operations_with(solution, values_of(*links)) < operations_with(solution, values_of(speeds));
  steps.append(takes_links ? along_links : over_speeds);
  return takes_links ? std::move(*links) : std::move(speeds);
}

}  // namespace gaussgen::strategy
