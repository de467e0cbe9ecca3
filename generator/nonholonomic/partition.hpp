#pragma once
// Which speeds are eliminated: α = (μ | p) with det |b_μρ| ≠ 0 (Vujičić (3.6); architecture, decision 5).

#include <optional>

#include "nonholonomic/constraint_rows.hpp"

namespace gaussgen::nonholonomic {

/// Position of a dependent speed μ, or of an independent one p, in the partition.
using DependentIndex = support::Index<struct DependentTag>;
using IndependentIndex = support::Index<struct IndependentTag>;

struct Partition {
  support::Indexed<DependentIndex, FreeIndex> dependent;
  support::Indexed<IndependentIndex, FreeIndex> independent;
  bool is_safe = false;  ///< det b_μρ is shown never to vanish: triangular, constants and parameters on the diagonal
};

/// The user's choice, or a safe one, or the best conditioned at the initial state. Nothing when every choice, or the
/// user's, is singular there: the paper's elimination does not apply.
std::optional<Partition> choose_partition(const model::Model& model, const gauss::System& system,
                                          const ConstraintRows& rows);

}  // namespace gaussgen::nonholonomic
