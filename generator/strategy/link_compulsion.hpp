#pragma once

#include "kinematics/linkage.hpp"
#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Z_w as in compulsion.hpp, from accelerations of links, each from that of the one before. Nothing where a body is on no link, or
/// forces are known by generalized components only.
std::optional<ir::Expr> compulsion_of_links(const Dynamics& dynamics, const kinematics::Linkage& linkage,
                                            const Vector& candidate, ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
