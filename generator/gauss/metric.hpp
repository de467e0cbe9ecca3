#pragma once
// The metric of E_{n+k}, its blocks, and the two inverses that must not be mixed up (theory, section 1).

#include "gauss/kinetic_form.hpp"
#include "symbolic/binding.hpp"

namespace gaussgen::gauss {

struct Metric {
  Table<FullIndex, FullIndex> G;        ///< G_AB
  Table<FreeIndex, FreeIndex> G_qq;     ///< g_αβ, the metric of M_n (1.10)
  Table<FreeIndex, HeldIndex> G_qx;     ///< g_αi (1.11): not zero in general
  Table<HeldIndex, HeldIndex> G_xx;     ///< the block G_ij: not э_ij
  Table<FreeIndex, FreeIndex> g_up;     ///< g^αβ, the inverse of g_αβ: not the αβ block of G^-1
  Table<FullIndex, FullIndex> G_up;     ///< G^AB, the inverse of G
  Table<HeldIndex, HeldIndex> E_xx;     ///< э_ij = G_ij - g_iα g^αβ g_βj, the Schur complement
  Table<HeldIndex, HeldIndex> E_xx_up;  ///< э^ij, the ij block of G^-1 (1.12)
};

Metric metric(const KineticForm& form, const Chart& chart, symbolic::Bindings& bindings);

}  // namespace gaussgen::gauss
