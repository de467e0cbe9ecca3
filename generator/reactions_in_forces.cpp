#include "reactions_in_forces.hpp"

#include <algorithm>

#include "ir/differentiate.hpp"
#include "ir/substitute.hpp"
#include "kinematics/solve_sparse.hpp"
#include "least_shares.hpp"
#include "mechanics.hpp"
#include "support/assert.hpp"

namespace gaussgen {

using ir::Expr;

namespace {

Expr reaction_of(const Mechanics& mechanics, const model::NamedReaction& of, const strategy::Vector& multipliers) {
  if (of.is_absent) return mechanics.expressions.number(0);
  if (!of.is_held) {
    const auto& rows = mechanics.dynamics.constraints;
    const auto row = std::find(rows.begin(), rows.end(), of.of);
    GAUSS_ASSERT(row != rows.end(), "constraint={}", of.of);
    return multipliers[static_cast<std::size_t>(row - rows.begin())];
  }
  const auto& held = mechanics.symbols.held;
  for (const auto i : held.indices()) {
    if (held[i].name == of.of) return mechanics.held_reactions[i.value];
  }
  GAUSS_ASSERT(false, "held coordinate={}", of.of);
  return mechanics.expressions.number(0);
}

}  // namespace

Expr reaction_of(const Mechanics& mechanics, const model::NamedReaction& of) {
  return reaction_of(mechanics, of, mechanics.solution.multipliers);
}

// r = r_0 + (∂r/∂ρ) ρ with ρ = r: (1 - ∂r/∂ρ) ρ = r_0.
std::optional<std::vector<Expr>> found_reactions(Mechanics& mechanics) {
  const std::vector<model::NamedReaction>& all = mechanics.model.reactions;
  ir::Substitution without(mechanics.graph);
  for (const ir::SymbolId symbol : mechanics.symbols.reactions)
    without.replace(symbol, mechanics.expressions.number(0));
  std::vector<std::vector<Expr>> matrix;
  std::vector<Expr> right;
  const strategy::Vector multipliers = shared_multipliers(mechanics);
  mechanics.steps.begin("reactions that forces depend on: linear in these forces (theory.md, section 10)");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Expr r = reaction_of(mechanics, all[i], multipliers);
    right.push_back(mechanics.steps.name(without(r), "without_friction_" + all[i].of));
    matrix.emplace_back();
    for (std::size_t j = 0; j < all.size(); ++j) {
      const Expr own = mechanics.expressions.number(i == j ? 1 : 0);
      matrix.back().push_back(own - without(ir::partial(r, mechanics.symbols.reactions[j])));
    }
  }
  return kinematics::solve_sparse(matrix, right, kinematics::LargeBlocks::eliminate);
}

}  // namespace gaussgen
