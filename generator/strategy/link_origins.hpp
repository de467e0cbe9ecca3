#pragma once
// Accelerations of links in space.

#include "strategy/link_axes.hpp"
#include "strategy/tree_motion.hpp"

namespace gaussgen::strategy {

/// Each is formed where it is asked for, and once for all links that share an origin.
class LinkOrigins {
 public:
  /// Refers to `motion` and `steps`.
  LinkOrigins(const TreeMotion& motion, ir::Graph& graph, Steps& steps);

  /// From the axes of a link to those of space.
  const ir::Matrix3& axes(std::size_t link) { return axes_.of(link, steps_); }

  /// Of the origin of a link against free fall, in the unit of length of `motion` per s².
  const ir::Vector3& acceleration(std::size_t link);

 private:
  const TreeMotion& motion_;
  Steps& steps_;
  LinkAxes axes_;
  std::vector<std::optional<ir::Vector3>> in_space_;
};

}  // namespace gaussgen::strategy
