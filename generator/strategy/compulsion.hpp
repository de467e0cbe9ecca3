#pragma once

#include <optional>

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

struct Compulsion {
  ir::Expr Z;
  ir::Expr singular_metric;  ///< Boolean: forces along coordinates cannot be spread here, and Z is not to be trusted
};

/// About the mass centre, in some axes.
struct NamedInertia {
  ir::Matrix3 tensor;
  bool is_isotropic;
  std::string name;
};

/// n·I⁻¹ n for a moment n in the axes of I, with I⁻¹ from parameters alone, so that it costs one preparation.
ir::Expr square_in_inverse_inertia(const NamedInertia& inertia, const ir::Vector3& n, ir::Expr epsilon, Steps& steps);

/// Gauss's function without reactions, Z_w of Vujičić (1.18), as the complete square of theory section 6 over the bodies:
/// 2 Z_w = Σ m |a - F/m|² + (ω̇ - ω̇₀)·I (ω̇ - ω̇₀), for candidate accelerations. Forces known only by their generalized
/// components are spread over the bodies as m J G^-1 Q, which leaves the minimum where it is. Unit: N²/kg.
/// Nothing where there are such forces, and free coordinates that others repeat: no motion of the bodies takes them up.
std::optional<Compulsion> compulsion(const Dynamics& dynamics, const Vector& candidate, ir::Expr epsilon, Steps& steps);

/// Whether there is such a function, without forming it.
bool has_compulsion(const Dynamics& dynamics);

}  // namespace gaussgen::strategy
