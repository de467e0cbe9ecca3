#pragma once
// What constraints do to each body, all of them together.

#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

/// All constraint forces on one body together, by Newton and Euler: m a - F and d(I ω)/dt - M, in space, the moment about the
/// mass centre. Forces that the model gives as potentials or generalized forces are in it, since they name no body.
struct BodyReaction {
  std::string body;
  ir::Vector3 force;                  ///< N
  std::optional<ir::Vector3> moment;  ///< N m; rigid bodies only
};

/// By links, or over speeds where that takes fewer operations or bodies are on no links.
std::vector<BodyReaction> body_reactions(const model::Model& model, const Dynamics& dynamics, const Solution& solution,
                                         Steps& steps);

/// From the accelerations along the speeds.
std::vector<BodyReaction> body_reactions_by_speeds(const Dynamics& dynamics, const Solution& solution, Steps& steps);

/// From the accelerations of links, where Z was minimised body by body: as many operations for each body, however many speeds move
/// it. Nothing where a body is on no link.
std::optional<std::vector<BodyReaction>> body_reactions_by_links(const model::Model& model, const Dynamics& dynamics,
                                                                 const Solution& solution, Steps& steps);

}  // namespace gaussgen::strategy
