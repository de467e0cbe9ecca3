#pragma once

#include <optional>

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Inputs that take part in forces, with what they have to be.
struct Drives {
  std::vector<std::size_t> inputs;  ///< index into Symbols::inputs
  Vector values;
  Vector accelerations;  ///< that they make
  ir::Expr singular_mass_matrix;
  ir::Expr dependent_constraints;
};

/// Generalized forces that have to be added for the accelerations `wanted`: g a - f - bᵀ λ with the multipliers of the motion without
/// them. Where `wanted` satisfies the constraints, these are the least ones as the inverse of g measures forces, since g times the
/// change of the accelerations they are at right angles to every bᵀ μ; and multipliers stay what they are.
Vector missing_forces(const Dynamics& dynamics, const Vector& wanted, const Vector& multipliers, Steps& steps);

/// The inputs u of f = f_0 + B u that make `wanted`. They are the multipliers of the servo constraints Bᵀ a = Bᵀ `wanted`: Gauss's
/// principle with these beside the constraints asks for the least change of the free motion, and where inputs and constraints are as
/// many as speeds nothing but `wanted` is left. Only the inputs in `sought`, by their index, are found. Nothing where none of these is
/// in forces, or where they are not linear in them.
std::optional<Drives> drives(const Dynamics& dynamics, const Vector& wanted, const std::vector<std::size_t>& sought,
                             ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
