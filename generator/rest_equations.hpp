#pragma once
// What has to vanish where a model rests.

#include <cstddef>
#include <utility>
#include <vector>

#include "mechanics.hpp"

namespace gaussgen {

/// f - g u̇ + bᵀ λ at rest, then the equations of positions, then φ and b u̇ + its drift at rest, which are zero in every position unless
/// a constraint drives the model; over its configuration and one multiplier λ for each constraint. u̇ is how speeds at rest change with
/// time: those against what moves.
struct RestEquations {
  explicit RestEquations(Mechanics& mechanics);

  std::vector<ir::SymbolId> multipliers;
  std::vector<ir::Expr> equations;
  std::vector<std::vector<ir::Expr>>
      derivatives;                             ///< of each equation, by displacements along speeds, then by multipliers
  std::vector<std::vector<ir::Expr>> rates;    ///< ∂q̇/∂u of each q, by speeds
  std::vector<std::vector<ir::Expr>> held;     ///< b of each constraint on velocities alone: no way leads across it
  std::vector<std::vector<ir::Expr>> closing;  ///< b of each equation of positions
  std::vector<std::vector<ir::Expr>> metric;   ///< g, by speeds
  std::vector<ir::Expr> changes;               ///< u̇
  std::vector<std::pair<std::size_t, std::size_t>>
      drives;  ///< equations that a constraint may drive, and that constraint

 private:
  void pose(Mechanics& mechanics);
  void add_drive(std::size_t constraint, ir::Expr drive);
  void differentiate(Mechanics& mechanics);
};

}  // namespace gaussgen
