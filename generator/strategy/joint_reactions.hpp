#pragma once

#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

/// Force (N) and moment (N m) that the child of a joint feels from its parent, in space, the moment about the origin of the child.
struct JointReaction {
  std::string joint;
  std::string child;
  std::string parent;
  ir::Vector3 force;
  ir::Vector3 moment;
};

/// By Newton and Euler for all that the joint carries: m a and d(I ω)/dt less the forces at places and those of constraints between
/// places. What acts along coordinates (generalized forces, potentials, springs along a coordinate, held coordinates, constraints on
/// rates) acts in the joints of these coordinates, and is part of what they transmit.
std::vector<JointReaction> joint_reactions(const model::Model& model, const Dynamics& dynamics,
                                           const Solution& solution, Steps& steps);

}  // namespace gaussgen::strategy
