#pragma once
// Accelerations and multipliers at a state at which constraints follow from each other, in as many digits as wanted.

#include <optional>
#include <vector>

#include "dependence.hpp"

namespace gaussgen {

struct GeneralSolution {
  std::vector<support::Rational> accelerations;  ///< of the free speeds
  std::vector<support::Rational> multipliers;    ///< those of least norm, as emitted code has it: gauss/constrained.hpp
};

/// At the state that is bound in `values`, where the constraints of `dependent` follow from the others and agree with them; nothing where inertia
/// and constraints together determine no motion, or an entry has no value.
std::optional<GeneralSolution> general_solution(Mechanics& mechanics, ModelValues& values,
                                                const std::vector<Dependence>& dependent);

/// Of those that do the same as `multipliers`, the least; nothing where an entry has no value.
std::optional<std::vector<support::Rational>> least_multipliers(Mechanics& mechanics, ModelValues& values,
                                                                const std::vector<Dependence>& dependent,
                                                                const std::vector<support::Rational>& multipliers);

/// Whether there is none since neither inertia nor the constraints that are left determine some acceleration.
bool is_undetermined(Mechanics& mechanics, ModelValues& values, const std::vector<Dependence>& dependent);

}  // namespace gaussgen
