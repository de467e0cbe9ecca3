#pragma once
// The paper's equations of a model: motion (3.7), holonomic reactions (3.8), multipliers (3.4).

#include <memory>

#include "nonholonomic/elimination.hpp"

namespace gaussgen::nonholonomic {

/// Everything the paper's route has to say about a model. Expressions are over y, ẏ, ÿ, t, parameters and inputs with
/// x free; ÿ of free coordinates stands for `accelerations` wherever a result mentions it.
struct PaperSystem {
  gauss::System system;
  ConstraintRows rows;
  Partition partition;
  Elimination elimination;

  Row<IndependentIndex> motion;  ///< (A_p - Q_p) + c_p^μ (A_μ - Q_μ), which vanishes (3.7)
  Row<FreeIndex> accelerations;  ///< q̈^α solved from (3.7) in the form Cᵀ g C, C = [c; 1], and φ̇ = 0
  Row<ConstraintIndex> lambda;   ///< A_μ - Q_μ = λ_ρ b_ρμ (3.4)
  Row<HeldIndex> R_x;            ///< R_j = A_j - Q_j - λ_μ β_μj (3.5)
  Row<HeldIndex> R_x_up;         ///< R^i = э^ij (a_j - F_j) + b^{μi} (A_μ - Q_μ) (3.8)

  const Chart& chart() const { return *system.chart; }
};

/// Nothing when the constraints are dependent at the initial state.
std::optional<PaperSystem> build_paper_system(const model::Model& model);

}  // namespace gaussgen::nonholonomic
