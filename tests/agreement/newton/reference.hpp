#pragma once
// What a state's accelerations and constraint forces are, from bodies that each have six accelerations: in a hundred digits, and of any rank.

#include "newton/loads.hpp"

namespace agreement::newton {

/// Gauss's principle over the accelerations w of all bodies, of which joints leave w = c + J a: J and c by moving the model, J also
/// being the null space by which the forces of joints leave the equations. What other constraints ask for is solved with its rank, and multipliers of least norm.
struct Reference {
  Reference(const gaussgen::model::Model& model, const Values& constants, const State& state);

  VectorX accelerations;  ///< of speeds
  VectorX reactions;      ///< bᵀλ along speeds
  VectorX units;          ///< sqrt(g_ii): what has them as units is of size 1; 1 where nothing has inertia
  Eigen::VectorXd
      sines;  ///< singular values of the rows, each of unit length with masses 1; descending, one for each row
  Eigen::Index rank = 0;      ///< of the rows, to 30 digits
  bool is_determined = true;  ///< by masses and rows together
  Real contradiction = 0;     ///< what rows leave open of what they ask for, relative
  Real open = 0;              ///< the same in units of accelerations
  double condition = 1;       ///< of [g bᵀ; b 0] with independent rows, in these units
  Real size = 0;              ///< of the terms that the equations are sums of, in these units; rounding is by eps of it

 private:
  struct System;
  void scale(System& system);
  void solve(System& system);
};

}  // namespace agreement::newton
