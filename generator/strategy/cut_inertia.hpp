#pragma once
// What the bodies between two cuts take for their accelerations: the part of reactions at cuts that grows with the model.

#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

inline constexpr std::size_t k_no_cut = static_cast<std::size_t>(-1);

/// Which cut carries what, however they lie to each other.
struct CutTree {
  std::vector<kinematics::Cut> cuts;
  std::vector<std::size_t> carrier;  ///< of frames: the last cut before what is fixed in them
  std::vector<std::size_t> before;   ///< of cuts: the one that carries their parents
  std::vector<std::size_t> inward;   ///< cuts, each after those that it carries
};

CutTree cut_tree(const model::Model& model, std::vector<kinematics::Cut> cuts);

struct Wrench {
  ir::Vector3 force;   ///< N, space
  ir::Vector3 moment;  ///< N m, space
};

/// A frame that turns freely about an axis of space: its moment about this axis is what acts along the speed.
struct FreeTurn {
  std::size_t axis;
  std::size_t speed;
  ir::Expr factor;  ///< the turn about the axis is this times the speed
};

/// Lists are parallel to the cuts.
struct CutInertia {
  std::vector<Wrench> own;        ///< about the origin of the frame: what is carried by no later cut
  std::vector<ir::Vector3> arms;  ///< m, space: this origin from that of the cut before
  std::vector<std::optional<FreeTurn>> turns;
  bool counts_loads = true;  ///< forces at places have been taken away as far as bodies feel them
};

/// m a - F and d(I ω)/dt - M of each body, from the accelerations along the speeds.
CutInertia inertia_by_bodies(const model::Model& model, const CutTree& tree, const Dynamics& dynamics,
                             const Solution& solution, Steps& steps);

/// Whether the accelerations of links are known, and tell what one cut carries from what another does.
bool links_tell_apart(const model::Model& model, const CutTree& tree, const Solution& solution);

/// m a and d(I ω)/dt against free fall, from the accelerations of links, which are known once Z has been minimised body by body.
/// Where links_tell_apart.
CutInertia inertia_by_links(const CutTree& tree, const Dynamics& dynamics, const Solution& solution, Steps& steps);

}  // namespace gaussgen::strategy
