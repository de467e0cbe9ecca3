#pragma once

#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

/// R_j = A_j - Q_j - λ_μ β_μj for every held coordinate (theory section 4; Vujičić (3.5), (3.8) in covariant form).
Vector held_reactions(const Dynamics& dynamics, const Solution& solution, Steps& steps);

/// λ_μ β_μα: what constraint μ adds to the right-hand side of the equation of the free α (Vujičić (3.4)).
Matrix generalized_reactions(const Dynamics& dynamics, const Solution& solution, Steps& steps);

/// Force (N) and moment (N m) of one constraint on one body, in space; the moment about `point` if the constraint names one,
/// else about the mass centre of the body.
struct ReactionWrench {
  std::string constraint;  ///< held coordinate or velocity constraint
  std::string body;
  ir::Vector3 force;
  std::optional<ir::Vector3> moment;  ///< rigid bodies only
  bool about_point = false;
};

/// Spreads each reaction over the bodies as the metric does: with z = G^-1 (covariant components), the force on body ν is
/// m_ν J_νA z^A and the moment I_ν W_νA z^A (m э_ν^i of theory section 1). For a body in full coordinates this is the force
/// R ∂x/∂r itself; in fewer coordinates it is the part inside E_{n+k}, all that Z determines (theory section 4).
std::vector<ReactionWrench> reaction_wrenches(const Dynamics& dynamics, const Solution& solution, const Vector& held,
                                              ir::Expr epsilon, Steps& steps);

/// Acceleration of a body's mass centre and of its rotation: J_A ÿ^A + h, W_A ÿ^A + η.
struct BodyAcceleration {
  ir::Vector3 linear;
  ir::Vector3 angular;
};

BodyAcceleration acceleration_of(const kinematics::BodyMotion& body, const Dynamics& dynamics, const Vector& free);

}  // namespace gaussgen::strategy
