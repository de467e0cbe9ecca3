#pragma once

#include "strategy/accelerations.hpp"

namespace gaussgen::strategy {

/// λ_μ β_μα: what constraint μ adds to the right-hand side of the equation of the free α (Vujičić (3.4)).
Matrix generalized_reactions(const Dynamics& dynamics, const Solution& solution, Steps& steps);

/// Force (N) and moment (N m) of one constraint on one body, in space; the moment about `point` if the constraint names one,
/// else about the mass centre of the body.
struct ReactionWrench {
  std::string constraint;  ///< held coordinate or velocity constraint
  std::string body;        ///< or the frame or point that feels it there
  ir::Vector3 force;
  std::optional<ir::Vector3> moment;  ///< rigid bodies only
  bool about_point = false;
  std::optional<ir::Vector3> at = {};  ///< where the force acts, if at a place that the constraint names
};

struct ReactionWrenches {
  std::vector<ReactionWrench> each;
  ir::Expr
      singular_metric;  ///< Boolean: here the coordinates do not release their bodies, and forces are not to be trusted
};

/// The force and moment of each constraint on each body that it reaches, for constraints over released coordinates
/// (release.hpp): with z = G^-1 (covariant components) they are m_ν J_νA z^A and I_ν W_νA z^A, m э_ν^i of theory section 1,
/// which there is R ∂x/∂r itself. Elsewhere Z does not determine them one by one; body_reactions has their sum.
ReactionWrenches reaction_wrenches(const Dynamics& dynamics, const Solution& solution, const Vector& held,
                                   ir::Expr epsilon, Steps& steps);

/// Constraints that reaction_wrenches leaves out.
std::vector<std::string> undetermined_wrenches(const Dynamics& dynamics, const Solution& solution, const Vector& held);

/// Acceleration of a body's mass centre and of its rotation: J_A ÿ^A + h, W_A ÿ^A + η.
struct BodyAcceleration {
  ir::Vector3 linear;
  ir::Vector3 angular;
};

BodyAcceleration acceleration_of(const kinematics::BodyMotion& body, const Dynamics& dynamics, const Vector& free);

/// From the axes of its ω to those of space.
ir::Vector3 in_space(const kinematics::BodyMotion& body, const ir::Vector3& v);

}  // namespace gaussgen::strategy
