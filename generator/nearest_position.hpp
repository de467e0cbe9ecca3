#pragma once
// Positions that satisfy the equations of positions, found from farther away than the emitted code can; and equations that nothing
// satisfies: lengths that do not meet, a point on two surfaces that do not touch.

#include <cstddef>
#include <optional>
#include <utility>
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

class PositionEquations;

/// Newton's method from where `equations` are, with the least displacements in these spans; false where it does not arrive at a solution, of which this part of
/// what equations are made of may be left; with `is_measured`, what displacements by the spans make of an equation counts among that.
bool nearest_solution(PositionEquations& equations, const std::vector<double>& spans, double part = 1e-13,
                      bool is_measured = false);

/// From a solution as many more steps as make less of what is left of it: to rounding.
void polish(PositionEquations& equations, const std::vector<double>& spans, bool is_measured = false);

/// Along the speeds that are `movable`, from the guesses of the model, at a time.
struct Approach {
  std::vector<double> position;  ///< the configuration that it came to
  bool is_solved = false;        ///< it satisfies all equations of positions
  bool is_settled = true;  ///< whichever of equations that follow from others the steps take: only rounding tells which
};

/// The steps of Newton's method that emitted code takes, each the least one in the mass metric.
Approach emitted_approach(Mechanics& mechanics, const std::vector<bool>& movable, double time);

/// Whether the guesses of the model are this position, and the steps of emitted code stay there, up to a small part of how far displacements go before constraints change.
bool is_held_from(Mechanics& mechanics, const std::vector<bool>& movable, const std::vector<double>& position,
                  double time);

/// This position, with angles that are more than half a turn from their guesses brought back by whole turns; nothing where there are none, or where it is not a solution then, as of
/// a rack and its wheel.
std::optional<std::vector<double>> less_whole_turns(Mechanics& mechanics, const std::vector<double>& position,
                                                    double time);

/// As many damped steps as it takes; angles end within half a turn of their guesses.
Approach long_approach(Mechanics& mechanics, const std::vector<bool>& movable, double time);

/// Whether, at this position, speeds that are `open` can be chosen such that all constraints hold: Newton's method finds them.
bool speeds_fit(Mechanics& mechanics, const std::vector<double>& position, const std::vector<bool>& open, double time);

/// Constraints that no speeds that are `open` satisfy at this position, and φ of each where the least is left; nothing where they fit.
std::vector<std::pair<std::size_t, double>> unmet_by_speeds(Mechanics& mechanics, const std::vector<double>& position,
                                                            const std::vector<bool>& open, double time);

/// What has to move beside what is `open`, so that all equations of positions hold to first order, from the guesses of the model: the
/// speeds along which the least such displacement goes.
std::vector<bool> needed_displacements(Mechanics& mechanics, const std::vector<bool>& open, double time);

/// Likewise the speeds that have to change at a position, so that all constraints hold.
std::vector<bool> needed_changes(Mechanics& mechanics, const std::vector<double>& position,
                                 const std::vector<bool>& open, double time);

}  // namespace gaussgen
