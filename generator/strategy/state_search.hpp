#pragma once
// How a state that satisfies the constraints is found: in stages, each over the state that the one before has reached, so that a step
// of Newton's method is one piece of code however often it is taken.

#include <optional>
#include <string>
#include <vector>

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// A state (configuration, then speeds) and the conditions under which it cannot be trusted.
struct ProjectedState {
  Vector configuration;
  Vector speeds;
  ir::Expr singular_mass_matrix;
  ir::Expr dependent_constraints;
  ir::Expr violated_constraints;
};

/// The same step with the change of the speeds (δu, or the displacement along them) left open: the least one with b δ + residuals = 0 in the metric g is to
/// be put in for the accelerations. Rows that ask for nothing and speeds that do not move are zeros.
struct OpenStep {
  Matrix g;
  Matrix b;
  Vector residuals;
  ProjectedState state;  ///< over symbols for accelerations
};

/// Of Newton's method from the guesses of a model to its initial state.
constexpr int k_steps_to_start = 8;

/// From the state that symbols stand for to `state`; the first stage of an initial state is over parameters alone.
struct SearchStage {
  enum class Kind {
    begin,      ///< given values and guesses, quaternions to unit length
    positions,  ///< a step on the equations of positions
    speeds,     ///< a step on the constraints of velocities
    check,      ///< whether constraints hold
  };
  Kind kind;
  int times;
  ProjectedState state;
  Steps steps;
  std::optional<OpenStep> open = {};  ///< of positions, of speeds
};

struct StateSearch {
  std::vector<SearchStage> stages;

  /// Where the last stage compares with the configuration before the first, these symbols stand for it; else none.
  Vector start;
};

/// From the state that symbols stand for: quaternions to unit length, then the smallest displacement (four steps) and the smallest change
/// of the speeds in the mass metric that satisfy the constraints: δu = -g^-1 bᵀ (b g^-1 bᵀ)^-1 φ. Exact for constraints linear in
/// the velocities, four steps for others, after which `violated_constraints` tells whether it was enough.
/// `start`: symbols for the configuration to compare with. `opens`: steps are made in open form, too.
StateSearch projection(const Dynamics& dynamics, const Vector& start, bool opens, ir::Expr epsilon);

/// To the model's initial state over parameters: rates and positions that the model does not give are found from the constraints by the
/// same steps restricted to them, starting from their guesses. `time` is put in where one stage is enough; others are over the symbol.
StateSearch initial_state(const model::Model& model, const Dynamics& dynamics, kinematics::Expressions& expressions,
                          ir::Expr time, bool opens, ir::Expr epsilon);

/// Its steps, once each, from the state that symbols stand for.
std::vector<ProjectedState> steps_to_initial_state(const model::Model& model, const Dynamics& dynamics,
                                                   kinematics::Expressions& expressions, ir::Expr epsilon);

}  // namespace gaussgen::strategy
