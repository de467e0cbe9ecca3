#pragma once

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

/// Of Newton's method from the guesses of a model to its initial state.
constexpr int k_steps_to_start = 8;

/// Quaternions to unit length, then the smallest change of the speeds in the mass metric that satisfies φ = 0:
/// δu = -g^-1 bᵀ (b g^-1 bᵀ)^-1 φ. Exact for constraints linear in the velocities, two Newton steps for others, after which
/// `violated_constraints` tells whether it was enough.
ProjectedState project(const Dynamics& dynamics, ir::Expr epsilon, Steps& steps);

/// `accelerations` with those in `open` changed so that the constraints hold, by the least change in the mass metric.
Vector completed_accelerations(const Dynamics& dynamics, Vector accelerations, const std::vector<std::size_t>& open,
                               ir::Expr epsilon, Steps& steps);

/// Configuration and speeds from which the search for open initial values starts; quaternions as the model gives them.
Vector guessed_state(const model::Model& model, kinematics::Expressions& expressions);

/// Speeds along which the search may change the configuration: those whose initial position the model leaves open.
std::vector<bool> open_positions(const model::Model& model, kinematics::Expressions& expressions);

/// Speeds that the model leaves to the constraints.
std::vector<bool> open_speeds(const model::Model& model, kinematics::Expressions& expressions);

/// The model's initial state at `time` over parameters. Rates that the model does not give are found from the constraints by the same
/// projection restricted to them, starting from their guesses.
ProjectedState initial_state(const model::Model& model, const Dynamics& dynamics, kinematics::Expressions& expressions,
                             ir::Expr time, ir::Expr epsilon, Steps& steps);

/// One more step of that search, from the configuration and the speeds that are bound to their symbols.
ProjectedState refined_state(const model::Model& model, const Dynamics& dynamics, kinematics::Expressions& expressions,
                             ir::Expr time, ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
