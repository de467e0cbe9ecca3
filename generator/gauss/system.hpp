#pragma once
// A model as the paper sees it: every object of sections 1 and 2 in GiNaC, x free (theory: x = c comes last).

#include <memory>

#include "gauss/compulsion.hpp"

namespace gaussgen::gauss {

struct System {
  std::unique_ptr<Chart> chart;
  symbolic::Bindings bindings;
  std::vector<BodyMotion> bodies;
  KineticForm kinetic;
  Metric metric;
  Connection connection;
  Row<FullIndex> Q;  ///< Q_A
  InvariantAccelerations invariant;
  Compulsion compulsion;
};

/// The largest n + k that the paper's route takes; above it Christoffel symbols cost more than they explain.
inline constexpr std::size_t k_largest_full_count = 12;

System build_system(const model::Model& model);

}  // namespace gaussgen::gauss
