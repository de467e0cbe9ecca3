#pragma once
// Velocities, Jacobians, velocity-squared accelerations and constraint rows over ALL y (theory, section 4), on the graph.

#include <optional>

#include "kinematics/expressions.hpp"
#include "kinematics/frames.hpp"
#include "support/lazy.hpp"

namespace gaussgen::kinematics {

/// One body's contribution: v = J_A ẏ^A + (terms of time), dv/dt = J_A ÿ^A + h; likewise ω with W_A and η.
struct BodyMotion {
  std::string name;
  ir::Expr mass;
  ir::Vector3 position;                        ///< m, space
  ir::Vector3 velocity;                        ///< m/s, space
  support::Indexed<FullIndex, ir::Vector3> J;  ///< ∂v/∂ẏ^A
  ir::Vector3 h;                               ///< m/s², space
  ir::Vector3 force;                           ///< N, sum of the active forces on the body, space
  ir::Vector3 moment;                          ///< N m, their moment about the mass centre, space

  bool is_rigid = false;  ///< the members below are meaningful for rigid bodies only
  bool is_isotropic = false;
  ir::Matrix3 inertia;  ///< kg m², about the mass centre, in the frame of ω
  Rotation rotation;
  support::Indexed<FullIndex, ir::Vector3> W;  ///< ∂ω/∂ẏ^A, in the frame of ω
  ir::Vector3 eta;                             ///< 1/s²

  /// I a, where an isotropic tensor is a factor in every frame.
  ir::Vector3 inertia_times(const ir::Vector3& a) const;
};

/// The direction of an action at the origin of a frame, as the model gives it.
struct LocalDirection {
  std::size_t place = model::k_space;  ///< frame at whose origin it acts
  std::size_t axes = model::k_space;   ///< frame in whose axes the components are
  ir::Vector3 components;
  std::size_t carrier = model::k_space;  ///< what it acts on, of which `place` may be a point that wanders over it
};

/// ∂φ/∂v of a constraint on something fixed in a frame, at a place there now: times the multiplier, the force on it (theory section 4).
struct ConstraintAction {
  std::size_t frame = model::k_space;
  ir::Vector3 point;      ///< m, space
  ir::Vector3 direction;  ///< space
  std::optional<LocalDirection> local = {};
  std::optional<ir::Expr> along_way = {};  ///< power per unit along the way of the place over what carries it
};

/// φ_μ with β_μA = ∂φ_μ/∂ẏ^A and φ̇_μ = β_μA ÿ^A + Θ_μ (Vujičić (3.1), theory section 3).
struct ConstraintRow {
  std::string name;
  std::string unit;           ///< of the multiplier; empty when it is not known
  std::optional<ir::Expr> f;  ///< of an implicit holonomic constraint f = 0, φ = df/dt (theory section 4)
  ir::Expr phi;
  support::Indexed<FullIndex, ir::Expr> beta;
  ir::Expr beta_drift;
  std::optional<ir::Vector3> point;       ///< where the reaction acts, space
  bool is_linear = true;                  ///< in the velocities
  std::vector<ConstraintAction> actions;  ///< where the constraint is one of places
  support::Indexed<FullIndex, ir::Expr>
      beside;  ///< the part of beta that is of no place, or of the way of places over what carries them
  support::Indexed<FullIndex, ir::Expr> carried;  ///< the part of beta that is of places on which no body feels it
  ir::Expr
      phi_beside;  ///< the part of phi that is of no rate of a place, where there are actions: of what time alone says
};

/// A frame as it is cut off from its parent, with all that it carries.
struct Cut {
  std::string name;                    ///< of the joint, or of the frame
  std::size_t frame = model::k_space;  ///< the child of a joint
  ir::Vector3 point;                   ///< its origin, m, space
  bool is_joint = false;
};

/// A frame that held coordinates move against its parent, and how it moves per rate of each, in space.
struct HeldFrame {
  Cut cut;
  support::Indexed<HeldIndex, ir::Vector3> velocity;  ///< ∂v/∂ẋ^j of its origin
  support::Indexed<HeldIndex, ir::Vector3> omega;     ///< ∂ω/∂ẋ^j
};

/// A force with its moment about a point, on a frame of the model, in space.
struct AppliedForce {
  std::size_t frame = model::k_space;
  ir::Vector3 point;          ///< m
  ir::Vector3 force;          ///< N
  ir::Vector3 moment;         ///< N m, about `point`
  ir::Vector3 unfelt_force;   ///< the part that no body has in its sums, at `point`
  ir::Vector3 unfelt_moment;  ///< likewise; of what acts beside a particle, its moment about the particle
};

/// What forces at places sum up to on a body, without fields.
struct BodyLoad {
  ir::Vector3 force;   ///< N, space
  ir::Vector3 moment;  ///< N m, space, about the mass centre
};

/// What impulses of contacts and dry friction are made of, where none of them acts (theory.md, section 11).
struct SwitchRows {
  std::vector<ConstraintRow> contacts;                ///< parallel to Model::contacts
  std::vector<std::vector<ConstraintRow>> frictions;  ///< parallel to Model::frictions: their slips
  std::vector<std::vector<ir::Expr>> limits;          ///< of each friction, per reaction of each contact
};

/// What follows from positions and velocities. Jacobians, of which there are as many as pairs of bodies and coordinates, are
/// formed where they are asked for.
struct Kinematics {
  Symbols symbols;
  support::Lazy<support::Indexed<BodyIndex, BodyMotion>> bodies;
  support::Indexed<ConstraintIndex, ConstraintRow> constraints;
  std::vector<ConstraintRow> idle_slips;              ///< rows that hold whatever the speeds are; their places only
  support::Lazy<std::vector<Cut>> joints;             ///< in the order of the model
  support::Lazy<std::vector<HeldFrame>> held_frames;  ///< parents first
  std::vector<std::string> frame_names;               ///< parallel to Model::frames
  support::Indexed<ConfigurationIndex, ir::Expr> configuration_rates;
  support::Indexed<FreeIndex, ir::Expr> speeds_at_rest;
  support::Lazy<ir::Expr> potential;                 ///< J; gravity (uniform fields) included
  std::vector<AppliedForce> applied;                 ///< forces at places
  support::Indexed<FullIndex, ir::Expr> body_force;  ///< Q_A of the forces in BodyMotion::force and moment but fields
  ir::Vector3 field;                                 ///< m/s², space: the sum of uniform fields
  support::Lazy<support::Indexed<FullIndex, ir::Expr>> field_force;  ///< Q_A of fields
  support::Indexed<FullIndex, ir::Expr> other_force;                 ///< Q_A of all other forces, not spread on bodies
  support::Indexed<FullIndex, ir::Expr>
      carried_force;                      ///< the part of other_force that is of places on which no body feels it
  std::vector<std::size_t> idle_forces;   ///< of Model::forces: no body, coordinate or joint feels them
  std::vector<std::size_t> inner_forces;  ///< between places of one rigid part, which cancel there
  support::Indexed<HeldIndex, ir::Expr> held_acceleration;  ///< c̈^i
  std::vector<std::vector<ir::Expr>> quantities;            ///< parallel to Model::quantities
  std::vector<ir::Expr> guards;                             ///< parallel to Model::guards
  std::vector<ir::Expr> guard_limits;                       ///< likewise, over symbols of reactions; 0 without one
  SwitchRows switches;                                      ///< of a ground regime
  std::vector<BodyLoad> loads;                              ///< of bodies
  support::Lazy<ir::Expr> other_potential;                  ///< J; without fields

  /// Some constraint is an equation of positions.
  bool has_positions() const;
};

/// Builds everything with x^i free, then puts x^i = c^i(t) in (theory section 3: derivatives first, x = c afterwards).
Kinematics build_kinematics(const model::Model& model, ir::Graph& graph, Expressions& expressions,
                            const Symbols& symbols);

}  // namespace gaussgen::kinematics
