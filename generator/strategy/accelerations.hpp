#pragma once

#include <memory>

#include "strategy/elimination.hpp"

namespace gaussgen::strategy {

struct TreeMotion;

/// Accelerations and multipliers with the conditions under which they cannot be trusted.
struct Solution {
  Vector accelerations;                           ///< n
  Vector multipliers;                             ///< l, λ_μ of (3.4)
  ir::Expr singular_mass_matrix;                  ///< boolean
  ir::Expr dependent_constraints;                 ///< boolean
  std::string description;                        ///< which form, and why it is safe
  std::vector<std::string> undetermined;          ///< speeds that nothing gives inertia, in any configuration
  std::vector<std::string> redundant;             ///< constraints that follow from others, in every configuration
  std::vector<std::size_t> dependent;             ///< speeds that elimination expresses by the others
  bool is_of_metric = true;                       ///< a solution of the system over g and b
  std::shared_ptr<const TreeMotion> motion = {};  ///< of the links, where these accelerations were found body by body
  std::vector<ir::NodeId> looked_at =
      {};  ///< what is divided by, and has no bound: where it is infinite, nobody else would see it
};

/// No nonholonomic constraints: g a = f (Vujičić (1.15)).
Solution solve_unconstrained(const Dynamics& dynamics, ir::Expr epsilon, Steps& steps);

/// (3.7) in the symmetric form Cᵀ g C that theory section 3 recommends; λ from A_μ - Q_μ = λ_ρ b_ρμ.
Solution solve_by_elimination(const Dynamics& dynamics, const Elimination& elimination, ir::Expr epsilon, Steps& steps);

/// (3.4) with b a + drift = 0: needs no choice of dependent speeds, so it holds where every choice breaks down somewhere.
Solution solve_with_multipliers(const Dynamics& dynamics, ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
