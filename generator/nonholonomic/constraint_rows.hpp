#pragma once
// Nonholonomic constraints, differentiated once (Vujičić (3.1)-(3.3), theory section 3).

#include "gauss/system.hpp"

namespace gaussgen::nonholonomic {

using gauss::Chart;
using gauss::ex;
using gauss::FreeIndex;
using gauss::FullIndex;
using gauss::HeldIndex;
using gauss::Row;
using gauss::Table;

/// μ: a nonholonomic constraint.
using ConstraintIndex = support::Index<struct ConstraintTag>;

struct ConstraintRows {
  std::vector<std::string> names;
  Row<ConstraintIndex> phi;                ///< φ_μ(y, ẏ, t) at θ = 0
  Table<ConstraintIndex, FullIndex> beta;  ///< β_μA = ∂φ_μ/∂ẏ^A; its free part is b_μα
  Row<ConstraintIndex> beta_drift;         ///< Θ_μ: φ̇_μ = β_μA ÿ^A + Θ_μ
  Table<ConstraintIndex, HeldIndex> b_x;   ///< b_μ^i = (β_μj - β_μα g^αβ g_βj) э^ji (3.3)

  std::size_t size() const { return names.size(); }
  std::vector<ConstraintIndex> indices() const { return phi.indices(); }
};

ConstraintRows constraint_rows(const model::Model& model, const gauss::System& system);

}  // namespace gaussgen::nonholonomic
