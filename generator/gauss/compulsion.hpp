#pragma once
// Gauss's function in Vujičić's invariant form (1.13) and its stationarity (1.15)-(1.19).

#include "gauss/connection.hpp"

namespace gaussgen::gauss {

/// The quantities that stand in Z, at a motion: expressions in ÿ, ẏ, y, t.
struct InvariantAccelerations {
  Row<FullIndex> A;       ///< A_A = G_AB ÿ^B + bias_A, covariant, over all y
  Row<FreeIndex> a_q_up;  ///< a^α = g^αβ A_β
  Row<HeldIndex> a_x;     ///< a_i = A_i - g_iα g^αβ A_β: coefficients of the dual э^i, not A_i
  Row<FreeIndex> Q_q_up;  ///< Q^α = g^αβ Q_β
  Row<HeldIndex> F_x;     ///< F_i = Q_i - g_iα g^αβ Q_β: not Q_i
};

/// Z as a function of the variables a^α, a_i, R_i, which are symbols here.
struct Compulsion {
  Row<FreeIndex> a_q_up;
  Row<HeldIndex> a_x;
  Row<HeldIndex> R_x;
  ex Z;                    ///< (1.13)
  ex Z_w;                  ///< Z without R, before (1.18)
  Row<FreeIndex> dZ_da_q;  ///< ∂Z/∂a^α (1.15)
  Row<HeldIndex> dZ_da_x;  ///< ∂Z/∂a_i (1.16)
  Row<HeldIndex> dZ_w_da_x;  ///< ∂Z_w/∂a_i (1.18): R^i = э^ij R_j of a holonomic system, (1.19) with indices put right
};

InvariantAccelerations invariant_accelerations(const Connection& connection, const Metric& metric,
                                               const Row<FullIndex>& Q, const Chart& chart);

Compulsion compulsion(const InvariantAccelerations& invariant, const Metric& metric, const Chart& chart);

/// f of `compulsion`'s variables at a motion: a^α and a_i replaced by their values.
ex at_motion(const ex& f, const Compulsion& compulsion, const InvariantAccelerations& invariant);

}  // namespace gaussgen::gauss
