#pragma once
// What the bodies between two joints take for their accelerations: the part of joint reactions that grows with the model.

#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

inline constexpr std::size_t k_no_joint = static_cast<std::size_t>(-1);

/// Which joint carries what. Lists of joints are parallel to Model::joints.
struct JointTree {
  std::vector<std::size_t> carrier;  ///< of frames: the last joint before what is fixed in them
  std::vector<std::size_t> before;   ///< of joints: the one that carries their parents
  std::vector<std::size_t> inward;   ///< joints, each after those that it carries
};

JointTree joint_tree(const model::Model& model);

struct Wrench {
  ir::Vector3 force;   ///< N, space
  ir::Vector3 moment;  ///< N m, space
};

/// A joint that turns freely about an axis of space: its moment about this axis is what acts along the speed.
struct FreeTurn {
  std::size_t axis;
  std::size_t speed;
  ir::Expr factor;  ///< the turn about the axis is this times the speed
};

struct JointInertia {
  std::vector<Wrench> own;        ///< of joints, about the origin of the child: what is carried by no later joint
  std::vector<ir::Vector3> arms;  ///< m, space: this origin from that of the joint before
  std::vector<std::optional<FreeTurn>> turns;
  bool counts_loads = true;  ///< forces at places have been taken away as far as bodies feel them
};

/// m a - F and d(I ω)/dt - M of each body, from the accelerations along the speeds.
JointInertia inertia_by_bodies(const model::Model& model, const JointTree& tree, const Dynamics& dynamics,
                               const Solution& solution, Steps& steps);

/// m a and d(I ω)/dt against free fall, from the accelerations of links, which are known once Z has been minimised body by body.
/// Nothing where links do not tell bodies of several joints apart.
std::optional<JointInertia> inertia_by_links(const model::Model& model, const JointTree& tree, const Dynamics& dynamics,
                                             const Solution& solution, Steps& steps);

}  // namespace gaussgen::strategy
