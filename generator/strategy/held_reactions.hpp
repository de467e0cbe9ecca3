#pragma once

#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

/// R_j of x^j = c^j(t) for every held coordinate, N for a length and N m for an angle, positive along growing x^j (theory section 4).
/// By virtual work along x^j of what is felt where x^j moves a frame against its parent, so that operations grow with the number of links; by
/// the metric over all coordinates where that takes fewer, or where accelerations of links are not known.
Vector held_reactions(const model::Model& model, const Dynamics& dynamics, const Solution& solution, Steps& steps);

/// R_j = A_j - Q_j - λ_μ β_μj over all coordinates and all bodies (Vujičić (3.5), (3.8) in covariant form).
Vector held_reactions_by_metric(const Dynamics& dynamics, const Solution& solution, Steps& steps);

/// The same from the wrenches at cuts: nothing where links do not give them.
std::optional<Vector> held_reactions_by_links(const model::Model& model, const Dynamics& dynamics,
                                              const Solution& solution, Steps& steps);

}  // namespace gaussgen::strategy
