#pragma once
// Two more derivations of the same motion: multipliers (3.4)-(3.5) and Appell's form (3.9)-(3.10).

#include "nonholonomic/reduction.hpp"

namespace gaussgen::nonholonomic {

/// ∂Z/∂a^α = λ_μ b_μα with φ̇_μ = 0 solved for λ first, without a partition:
///   q̈ = g^-1 (βᵀ λ - f)
/// f_α = g_αi ẍ^i + bias_α - Q_α and, from φ̇ = 0, λ_ν β_μα g^αβ β_νβ = β_μα g^αβ f_β - β_μi ẍ^i - Θ_μ.
struct MultiplierForm {
  Row<ConstraintIndex> lambda;
  Row<FreeIndex> accelerations;
};

MultiplierForm multiplier_form(const ConstraintRows& rows, gauss::System& system);

/// ∂S/∂a^p - Q_p + c_p^μ (∂S/∂a^μ - Q_μ), which vanishes (3.9)-(3.10), with S from the accelerations of the bodies.
Row<IndependentIndex> appell_residual(const PaperSystem& paper);

}  // namespace gaussgen::nonholonomic
