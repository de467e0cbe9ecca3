#pragma once
// The covariant objects over all y = (free, held): G_AB, bias_A, Q_A (theory sections 1, 4 and 6).

#include "kinematics/kinematics.hpp"

namespace gaussgen::kinematics {

/// Symmetric matrix over the full index; both halves are stored.
using FullMatrix = support::Indexed<FullIndex, support::Indexed<FullIndex, ir::Expr>>;

struct Covariant {
  FullMatrix G;                                ///< G_AB = Σ m J_A·J_B + W_A·I W_B (1.10), (1.11), block G_ij
  support::Indexed<FullIndex, ir::Expr> bias;  ///< Σ m J_A·h + W_A·(I η + ω × I ω), so that A_A = G_AB ÿ^B + bias_A
  support::Indexed<FullIndex, ir::Expr> Q;  ///< all active forces
  ir::Expr kinetic_energy;
};

Covariant build_covariant(const Kinematics& kinematics, ir::Graph& graph);

}  // namespace gaussgen::kinematics
