#pragma once

#include "kinematics/linkage.hpp"
#include "strategy/ldl.hpp"

namespace gaussgen::strategy {

/// The metric g (1.10) of the free speeds by composite bodies (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 6): each entry is what
/// the momentum of all that one link carries, moved by one speed, does along the other speed.
Matrix composite_metric(const kinematics::Linkage& linkage, const std::vector<std::string>& labels, ir::Graph& graph,
                        Steps& steps);

/// Its diagonal: what speed alone takes as momentum, at a few operations for each link.
Vector composite_inertias(const kinematics::Linkage& linkage, const std::vector<std::string>& labels, ir::Graph& graph,
                          Steps& steps);

}  // namespace gaussgen::strategy
