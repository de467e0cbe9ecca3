#pragma once
// Body-by-body minimisation of Z: dynamic programming on Gauss's function (theory section 4; A. F. Vereshchagin, Engineering
// Cybernetics 12, 1974; R. Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 7).

#include <optional>

#include "strategy/accelerations.hpp"
#include "strategy/link_rows.hpp"

namespace gaussgen::strategy {

/// What is added to the equations of links, in their axes: all parallel to the links.
struct Disturbance {
  /// To the acceleration of an origin that a turn leaves where it is; of turns between a floating base and its anchor, from where its
  /// acceleration is found, in the axes before the turn.
  std::vector<ir::Vector3> linear;
  std::vector<ir::Vector3> force;  ///< to what a link takes for its acceleration, at its origin
  std::vector<ir::Vector3> moment;
};

/// A tree of links with what acts on it.
struct TreeProblem {
  const kinematics::Linkage& linkage;
  const kinematics::Symbols& symbols;
  ir::Vector3 field;  ///< m/s², space: the sum of uniform fields
  Vector forces;      ///< of the free speeds, without uniform fields
  ConstraintProblem constraints;
  std::string prefix;                        ///< of names
  const Disturbance* disturbance = nullptr;  ///< with the drift by link, and blocks divided at once
  /// Of bodies, each of which is on a link; empty where none is known, or some is not. `forces` has their part, too.
  std::vector<kinematics::BodyLoad> loads = {};
  Vector forces_beside = {};        ///< `forces` without the part of the loads
  ir::Rational least_response = 0;  ///< as in Dynamics
};

/// Where accelerations that come from velocities enter.
enum class Drift {
  by_link,      ///< each link moves Z by its own: fewest operations in a plane
  accumulated,  ///< all up to a link, from the ground on, with free fall: fewest in space
};

struct TreeForm {
  Drift drift = Drift::by_link;
  ir::Rational length = 1;    ///< m: the unit in which Z is minimised; of many equal lengths, theirs saves operations
  ir::Rational mass = 1;      ///< kg, likewise
  bool chooses_axes = false;  ///< such that turns by fixed angles vanish
  bool puts_loads_on_links =
      false;               ///< forces at places go down the tree, and not along all the speeds that move the place
  bool postpones = false;  ///< divisions by the pivots of bars, so that what hangs on them does not wait: see bar.hpp
};

/// Accelerations at a cost that grows with the number of links. Nothing where some acceleration has no inertia in any
/// configuration.
std::optional<Solution> solve_tree(const TreeProblem& problem, const TreeForm& form, ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
