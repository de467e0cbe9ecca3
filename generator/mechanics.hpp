#pragma once
// The emitted route as one object: a model on the graph, its accelerations, multipliers and reactions.

#include <memory>

#include "strategy/reactions.hpp"

namespace gaussgen {

struct MechanicsOptions {
  bool fold = false;                ///< parameters become numbers
  bool force_multipliers = false;   ///< the multiplier form (3.4) even where a safe partition exists (a check)
};

/// Not copyable: `dynamics` refers to `kinematics` and `covariant`, all of them to `graph`.
struct Mechanics {
  Mechanics(const model::Model& model, const MechanicsOptions& options);
  Mechanics(const Mechanics&) = delete;
  Mechanics& operator=(const Mechanics&) = delete;

  const model::Model& model;
  ir::Graph graph;
  kinematics::Symbols symbols;
  kinematics::Expressions expressions;
  kinematics::Kinematics kinematics;
  kinematics::Covariant covariant;
  strategy::Steps steps;  ///< of everything up to the held reactions
  strategy::Dynamics dynamics;
  strategy::Solution solution;
  strategy::Vector held_reactions;

  ir::Expr epsilon() const { return expressions.symbol(symbols.epsilon); }
};

}  // namespace gaussgen
