#pragma once
// How the axes of links lie in space.

#include "kinematics/linkage.hpp"
#include "strategy/steps.hpp"

namespace gaussgen::strategy {

/// From the ground on, each from the one before. Turns about one axis that follow each other are one, whose sine and cosine come from those
/// of its parts: sines and cosines of sums would be more calls, which are what takes longest.
class LinkAxes {
 public:
  LinkAxes(const std::vector<kinematics::Link>& links, ir::Graph& graph)
      : links_(links), graph_(graph), known_(links.size()) {}

  /// From the axes of a link, or of the ground, to those of space.
  const ir::Matrix3& of(std::size_t link, Steps& steps);

 private:
  struct Turned {
    ir::Matrix3 base;  ///< of the axes before the last turn
    std::size_t axis;  ///< of this turn
    std::optional<ir::Expr> angle, sine, cosine;
    ir::Matrix3 matrix;
  };

  bool is_first(const ir::Matrix3& base) const;
  Turned outward(std::size_t link, const Turned& before, Steps& steps) const;
  void turn(const kinematics::Link& link, const Turned& before, Turned& result, Steps& steps) const;

  const std::vector<kinematics::Link>& links_;
  ir::Graph& graph_;
  std::vector<std::optional<Turned>> known_;
  std::optional<ir::Matrix3> ground_;
};

}  // namespace gaussgen::strategy
