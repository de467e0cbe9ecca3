#pragma once

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// `accelerations` with those in `open` changed so that the constraints hold, by the least change in the mass metric.
Vector completed_accelerations(const Dynamics& dynamics, Vector accelerations, const std::vector<std::size_t>& open,
                               ir::Expr epsilon, Steps& steps);

/// Values that a model gives, over its parameters, and what it leaves to the constraints.
struct GivenState {
  Vector configuration;  ///< quaternions as the model gives them
  Vector speeds;
  std::vector<std::size_t> open;            ///< speeds
  std::vector<std::size_t> open_positions;  ///< speeds along which the configuration may still change
};

GivenState given_state(const model::Model& model, kinematics::Expressions& expressions);

/// Configuration and speeds from which the search for open initial values starts; quaternions as the model gives them.
Vector guessed_state(const model::Model& model, kinematics::Expressions& expressions);

/// Speeds along which the search may change the configuration: those whose initial position the model leaves open.
std::vector<bool> open_positions(const model::Model& model, kinematics::Expressions& expressions);

/// Speeds that the model leaves to the constraints.
std::vector<bool> open_speeds(const model::Model& model, kinematics::Expressions& expressions);

}  // namespace gaussgen::strategy
