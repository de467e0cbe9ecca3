#pragma once

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Gauss's function without reactions, Z_w of Vujičić (1.18), as the complete square of theory section 6 over the bodies:
/// 2 Z_w = Σ m |a - F/m|² + (ω̇ - ω̇₀)·I (ω̇ - ω̇₀), for candidate accelerations. Forces known only by their generalized
/// components are spread over the bodies as m J G^-1 Q, which leaves the minimum where it is. Unit: N²/kg.
ir::Expr compulsion(const Dynamics& dynamics, const Vector& candidate, ir::Expr epsilon, Steps& steps);

}  // namespace gaussgen::strategy
