#pragma once
// Statics: where a model stays when it is let go at rest.

#include <string>
#include <vector>

#include "mechanics.hpp"
#include "support/rational.hpp"

namespace gaussgen {

struct Equilibrium {
  std::string failure;              ///< why there is none; empty
  std::string remedy;               ///< what to do about that, where it is known
  std::vector<std::string> doubts;  ///< that it lasts, or is where it is found
  /// λ of each constraint, which no mass has a part in: where the mass matrix is singular, they have values all the same.
  std::vector<support::Rational> multipliers;
};

/// Changes the initial state of `model`, from which `mechanics` was made, to one with all free speeds 0 in which nothing accelerates:
/// f(y, 0) + bᵀ λ = 0 with all constraints satisfied and no drift in them. From the initial position, by Levenberg's and Marquardt's
/// method over positions and multipliers, which goes the shorter way, as masses measure it, where many positions would do. Held
/// coordinates move as their laws say, so it may be a relative equilibrium. Good to `digits` digits.
Equilibrium go_to_equilibrium(Mechanics& mechanics, model::Model& model, const support::Rational& time, int digits);

}  // namespace gaussgen
