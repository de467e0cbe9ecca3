#pragma once
// Positions that satisfy the equations of positions, found from farther away than the emitted code can; and equations that nothing
// satisfies: lengths that do not meet, a point on two surfaces that do not touch.

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanics.hpp"

namespace gaussgen {

/// Equations that no position near the initial one satisfies together, and by how much the nearest violates each: there
/// Σ y_μ ∂f_μ/∂q = 0 with y_μ of the sign of f_μ, so that to first order no displacement makes all of them smaller.
struct Contradiction {
  std::vector<std::size_t> constraints;  ///< into Model::constraints
  std::vector<double> residuals;         ///< f_μ
};

/// By a search from the initial position, with every coordinate free to move; nothing where it finds a solution, or no answer.
std::optional<Contradiction> contradictory_positions(Mechanics& mechanics);

/// A configuration that satisfies all equations of positions, reached from the guesses along the speeds that are `movable`; nothing where
/// the search finds none.
std::optional<std::vector<double>> nearest_position(Mechanics& mechanics, const std::vector<bool>& movable);

}  // namespace gaussgen
