#pragma once
// The kinetic energy as a form in the rates: T = ½ G_AB ẏ^A ẏ^B + B_A ẏ^A + T_0 (theory, sections 1, 4 and 6).

#include "gauss/body_motion.hpp"

namespace gaussgen::gauss {

/// Over the chart, x free and θ free: this is what derivatives are taken of.
struct KineticForm {
  Table<FullIndex, FullIndex> G;  ///< Σ m r_A·r_B + W_A·I W_B
  Row<FullIndex> B;               ///< Σ m r_A·∂r/∂t + W_A·I w_0, for explicit time
  ex T_0;                         ///< ½ Σ m (∂r/∂t)² + w_0·I w_0
};

KineticForm kinetic_form(const std::vector<BodyMotion>& bodies, const Chart& chart);

}  // namespace gaussgen::gauss
