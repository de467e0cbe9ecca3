#pragma once

#include "strategy/cut_inertia.hpp"

namespace gaussgen::strategy {

/// What each frame feels from its parent where it is cut off, in the order of the cuts: force (N) and moment (N m) in space, the moment about the origin of the
/// frame. By Newton and Euler for all that it carries: m a and d(I ω)/dt less the forces at places and those of constraints between
/// places (theory section 4).
std::vector<Wrench> cut_wrenches(const model::Model& model, CutTree tree, const Dynamics& dynamics,
                                 const Solution& solution, Steps& steps);

}  // namespace gaussgen::strategy
