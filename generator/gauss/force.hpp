#pragma once

#include "gauss/body_motion.hpp"
#include "symbolic/binding.hpp"

namespace gaussgen::gauss {

/// Q_A = Σ F·r_A: virtual work of the active forces per unit of δy^A; -∂V/∂y^A for potentials (theory, section 6).
Row<FullIndex> active_force(const model::Model& model, const std::vector<BodyMotion>& bodies, const Chart& chart,
                            symbolic::Bindings& bindings);

}  // namespace gaussgen::gauss
