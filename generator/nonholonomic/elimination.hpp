#pragma once
// Dependent accelerations through independent ones (Vujičić (3.6), theory section 3).

#include "nonholonomic/partition.hpp"

namespace gaussgen::nonholonomic {

/// δa^μ = c_p^μ δa^p + b^{μi} δa_i. The paper prints both without the minus: with its sign the equations do not agree
/// with the multiplier form (tests/nonholonomic/test_printed_signs.cpp).
struct Elimination {
  Table<DependentIndex, ConstraintIndex> b_inv;   ///< (b^-1)^{μρ} of b_μρ: the dependent columns of β
  Table<DependentIndex, IndependentIndex> c_dep;  ///< c_p^μ = -(b^-1)^{μρ} b_ρp
  Table<DependentIndex, HeldIndex> b_x_up;        ///< b^{μi} = -(b^-1)^{μρ} b_ρ^i
  Row<DependentIndex> drift;  ///< q̈^μ = c_p^μ q̈^p + drift: -(b^-1)^{μρ} (β_ρi ẍ^i + Θ_ρ)
};

Elimination elimination(const ConstraintRows& rows, const Partition& partition, gauss::System& system);

}  // namespace gaussgen::nonholonomic
