#pragma once
// Derivatives of the accelerations of a tree, by the equations that link by link have in common what is solved: accelerations of links, each
// from that of the one before, and wrenches between them. Differentiated one by one at fixed accelerations and wrenches, they are the same
// equations with other inhomogeneous terms, and the tree that is factorised already solves them for one more right-hand side (by
// whole bodies and over coordinates: J. Carpentier, N. Mansard, Robotics: Science and Systems XIV, 2018).

#include "ir/substitute.hpp"
#include "kinematics/linkage.hpp"
#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

/// What hangs beside others on one link. Where nothing in it is disturbed, it only follows that link.
struct Limb {
  Vector before;                          ///< what the accelerations of that link are made of
  std::vector<std::size_t> disturbances;  ///< of its own equations
  std::vector<std::size_t> speeds;
};

/// With x what derivatives are taken by: terms(x) are the inhomogeneous terms of the equations of links, over symbols that stand for what is
/// solved; accelerations is what the terms d do to links at rest, linear in d.
struct TreeTangent {
  Vector terms;
  std::vector<ir::SymbolId> disturbances;  ///< d, parallel to the terms
  Vector accelerations;                    ///< along the speeds
  ir::Substitution solved;                 ///< from the symbols to what is solved
  std::vector<Limb> limbs;                 ///< those that carry others before these
};

/// Not where constraints, or speeds that are angular velocities along other axes, are in the equations.
bool has_tree_tangent(const Dynamics& dynamics, const Solution& solution);

/// `steps` gets accelerations and wrenches of links, in words.
TreeTangent tree_tangent(const Dynamics& dynamics, const Solution& solution, ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
