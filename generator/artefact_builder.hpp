#pragma once
// What the builders of artefacts share.

#include <functional>
#include <string>
#include <vector>

#include "emit/unit.hpp"
#include "mechanics.hpp"

namespace gaussgen {

std::vector<emit::NodeId> ids(const strategy::Vector& values);
std::vector<emit::NodeId> ids(const ir::Vector3& v);
std::vector<emit::NodeId> ids(const strategy::Matrix& rows);  ///< row by row

/// dphi/du of a constraint.
strategy::Vector gradient_of(const Mechanics& mechanics, const kinematics::ConstraintRow& row);

/// Coordinates and quaternions as the caller gives them.
strategy::Vector configuration_of(const Mechanics& mechanics);

/// Accelerations as the caller gives them.
strategy::Vector candidate_accelerations(const Mechanics& mechanics);

/// Fills the parts that every artefact has.
class ArtefactBuilder {
 public:
  ArtefactBuilder(std::string name, std::string about, Mechanics& mechanics);

  emit::Artefact& artefact() { return artefact_; }

  void result_type(const std::string& type);
  void fields(const std::string& name, const std::string& type, const std::string& about,
              std::vector<emit::Field> fields);

  /// A state whose quaternions are not of unit length is what the function is for; others say that they do not trust it.
  void with_any_quaternion();

  /// The accelerations are not to be trusted when the mass matrix is singular or constraints depend on each other.
  void with_solution_status();

  /// Nor what the metric of coordinates tells, where this Boolean holds.
  void with_singular_metric(ir::Expr is_singular);

  /// Adds the steps of the solution, then `own` ones, and the test for finite results.
  emit::Artefact finish(const strategy::Steps& own);

 private:
  void add_sections(const std::vector<strategy::Step>& steps);
  emit::NodeId not_finite() const;

  Mechanics& mechanics_;
  emit::Artefact artefact_;
  std::vector<emit::NodeId> looked_at_;  ///< beside the results
};

/// rhs, reactions, rhs_and_reactions, reaction_forces.
emit::Artefact rhs_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> reactions_artefacts(Mechanics& mechanics);
std::vector<emit::Artefact> reaction_forces_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> joint_reactions_artefact(Mechanics& mechanics);

/// Constraints that may lose their rank somewhere, in a model that is small enough.
bool has_general_way(Mechanics& mechanics);

/// metric a = f + bᵀ λ, b a + drift = 0. `off`: square of the part by which positions are off the equations that each constraint may follow from;
/// `drift_error`: how far drifts may be off; zeros where nothing asks for them.
struct LinearProblem {
  strategy::Matrix metric;
  strategy::Vector f;
  strategy::Matrix b;
  strategy::Vector drift;
  strategy::Vector off;
  strategy::Vector drift_error;
};

/// Functions that fill the struct LinearSystem: of the accelerations, and of a given problem, which has as many speeds and rows.
emit::Artefact linear_system_artefact(Mechanics& mechanics);
emit::Artefact linear_system(const std::string& name, const LinearProblem& problem, Mechanics& mechanics);

/// A function in its own way and from a given solution, both under other names then, and the one that calls them. Of `ways` the rest is given.
std::vector<emit::Artefact> two_ways(emit::Artefact regular, emit::Artefact of_solution, emit::TwoWays ways);

/// A function that has no other way than the general solution of the accelerations, to whose derivatives `rates` leaves some entries.
std::vector<emit::Artefact> of_general_solution(emit::Artefact of_solution, emit::Rates rates, Mechanics& mechanics);

/// What `build` makes, in two ways each where the model has a general one; `shows_multipliers`: results contain them, or what follows from single
/// ones.
using ArtefactsOf = std::function<std::vector<emit::Artefact>(Mechanics&)>;
std::vector<emit::Artefact> in_two_ways(const ArtefactsOf& build, bool shows_multipliers, Mechanics& mechanics);

/// Of models with a general way.
std::vector<emit::Artefact> mobility_artefact(Mechanics& mechanics);

bool has_quaternions(const Mechanics& mechanics);

/// False where a body has no inertia to divide by, or no motion of the bodies takes up forces that are known by generalized components.
bool has_compulsion(Mechanics& mechanics);

/// What is known of a state, and states themselves.
emit::Artefact energy_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> compulsion_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> residuals_artefact(Mechanics& mechanics);
emit::Artefact mass_matrix_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> project_artefacts(Mechanics& mechanics);
std::vector<emit::Artefact> inverse_dynamics_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> jacobian_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> sensitivities_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> quantities_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> guards_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> impact_system_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> load_system_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> poses_artefact(Mechanics& mechanics);
std::vector<emit::Artefact> taylor_artefact(Mechanics& mechanics);

/// False where a model has no state, or constraints follow from others wherever they hold: the cheap way, which has a series, is always lost.
bool has_taylor(Mechanics& mechanics);
std::vector<emit::Artefact> initial_state_artefacts(Mechanics& mechanics);

}  // namespace gaussgen
