#pragma once

#include "kinematics/linkage.hpp"
#include "strategy/compulsion.hpp"

namespace gaussgen::strategy {

/// Z_w as in compulsion.hpp, from accelerations of links, each from that of the one before. With z = G^-1 Q of forces known by
/// generalized components only, what bodies take for z has to be taken away from what they take for the candidate; both are linear, so
/// it is what they take for the difference, and z is what the forces do to the links at rest. Nothing where a body is on no link, or
/// where there are such forces beside held coordinates, or speeds without inertia.
std::optional<Compulsion> compulsion_of_links(const Dynamics& dynamics, const kinematics::Linkage& linkage,
                                              const Vector& candidate, ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
