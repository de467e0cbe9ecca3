#pragma once
// What the body-by-body minimisation of Z knows of each link beside the accelerations along the speeds.

#include "strategy/link_motion.hpp"
#include "strategy/mass_properties.hpp"
#include "strategy/own_components.hpp"

namespace gaussgen::strategy {

/// A speed along which this link turns and nothing else moves; the turn is `factor` times the speed.
struct SoleFreedom {
  std::size_t speed;
  ir::Expr factor;
};

/// All lists are parallel to the links of `linkage`.
struct TreeMotion {
  kinematics::Linkage linkage;        ///< as it was walked along, in the units `length` and `mass`
  std::vector<std::size_t> carriers;  ///< the links before, also of wheels that hang elsewhere in `linkage`
  std::vector<std::optional<SoleFreedom>> sole;
  std::vector<MassProperties> properties;       ///< in those units, with masses at the ends of bars
  Vector moved;                                 ///< the part of the mass that belongs to the link before
  std::vector<LinkAcceleration> accelerations;  ///< against free fall, in the axes of the link; of links with mass
  std::vector<ir::Vector3> omega;               ///< rad/s, of the bodies, in the axes of the link
  std::vector<std::size_t> origins;             ///< the first link with the same origin; k_ground where this is fixed
  ir::Vector3 fall;                             ///< of the ground against free fall, in the unit of length
  ir::Rational length;                          ///< m
  ir::Rational mass;                            ///< kg
  std::vector<FloatingBase> bases = {};
};

std::vector<std::optional<SoleFreedom>> sole_freedoms(const std::vector<kinematics::Link>& links);

/// All bodies: then sums over speeds may take fewer operations than sums over links.
bool are_moved_by_few_speeds(const TreeMotion& motion);

}  // namespace gaussgen::strategy
