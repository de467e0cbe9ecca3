#pragma once
// Christoffel symbols and what the acceleration has besides second derivatives (theory, sections 2 and 4).

#include "gauss/metric.hpp"

namespace gaussgen::gauss {

struct Connection {
  /// [BC, A] = ½ (∂_C G_AB + ∂_B G_AC - ∂_A G_BC), first kind, of the full metric: gamma_first[A][B][C].
  support::Indexed<FullIndex, Table<FullIndex, FullIndex>> gamma_first;
  /// A_A = G_AB ÿ^B + bias_A: Lagrange's derivative of T without the second derivatives. It is formed from G, B_A and
  /// T_0, never from accelerations of points: that is the emitted route.
  Row<FullIndex> bias;
};

Connection connection(const KineticForm& form, const Chart& chart, symbolic::Bindings& bindings);

/// Γ^α_βγ of the induced metric g_αβ.
ex Gamma_q(const Connection& connection, const Metric& metric, const Chart& chart, FreeIndex a, FreeIndex b,
           FreeIndex c);

/// Γ^A_BC of the full metric G.
ex Gamma_y(const Connection& connection, const Metric& metric, const Chart& chart, FullIndex A, FullIndex B,
           FullIndex C);

}  // namespace gaussgen::gauss
