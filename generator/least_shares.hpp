#pragma once
// Constraints that follow from each other share one load: which part of it each has, where forces depend on that.

#include "mechanics.hpp"

namespace gaussgen {

/// Multipliers of the solution. Where usually fewer constraints say something of their own than there are, those that are least in the
/// sum of (length_mu lambda_mu)², with lengths of rows where inertias are 1: as emitted code reports them (gauss/constrained.hpp), and
/// whatever the order of the constraints (theory.md, section 10).
strategy::Vector shared_multipliers(Mechanics& mechanics);

}  // namespace gaussgen
