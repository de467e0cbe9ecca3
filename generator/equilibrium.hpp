#pragma once
// Statics: where a model stays when it is let go at rest.

#include <string>

#include "model/model.hpp"
#include "support/rational.hpp"

namespace gaussgen {

struct Equilibrium {
  std::string failure;  ///< why there is none; empty
  bool lasts = true;    ///< not only at this instant: laws and forces in time would move it soon
};

/// Changes the initial state of the model to one with all free speeds 0 in which nothing accelerates: f(y, 0) + bᵀ λ = 0 with all
/// constraints satisfied and no drift in them, by Newton's method over positions and multipliers from the initial position, each step the
/// least one where several would do. Held coordinates move as their laws say, so it may be a relative equilibrium. Good to
/// `digits` digits.
Equilibrium go_to_equilibrium(model::Model& model, const support::Rational& time, int digits);

}  // namespace gaussgen
