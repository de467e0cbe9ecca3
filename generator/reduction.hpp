#pragma once
// The motion near a state over what constraints leave independent.

#include <vector>

#include "analysis/blocks.hpp"
#include "analysis/independent.hpp"
#include "linear_equations.hpp"

namespace gaussgen {

/// Which displacements and speeds are independent. Chosen once; the same at states nearby.
struct IndependentChoice {
  analysis::Independent positions;  ///< among n displacements, by equations of positions
  analysis::Independent speeds;     ///< among n speeds, by all constraints
  std::vector<std::size_t> all;     ///< among 2n

  /// Of it, those that are displacements.
  std::size_t position_count() const { return positions.independent.size(); }
};

/// How readily displacements, and speeds, become dependent: what the model leaves open to constraints before what it states, and what
/// it names under `elimination` first.
struct Preferences {
  explicit Preferences(Mechanics& mechanics);

  std::vector<double> positions, speeds;
};

IndependentChoice choose(const Preferences& preferences, const LinearNumbers& numbers);

/// A, B and rates over the independent ones: dependent displacements by the equations of positions, dependent speeds by the constraints
/// on velocities, which change with displacements, too.
struct ReducedMotion {
  analysis::Matrix parametrised;  ///< 2n rows: change of everything by that of the independent ones
  analysis::Matrix A, B;
  analysis::Vector rates, by_time;
};

/// Nothing where the dependent ones are not determined here.
std::optional<ReducedMotion> reduce(const LinearNumbers& numbers, const IndependentChoice& choice);

/// How dependent displacements and speeds have to change, to first order, so that constraints hold; zero for independent ones.
std::optional<analysis::Vector> closing(const LinearNumbers& numbers, const IndependentChoice& choice);

}  // namespace gaussgen
