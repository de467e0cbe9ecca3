#pragma once
// A mechanical system as nothing but positions of mass points, forces and constraints, and Gauss's principle done
// directly on it: Z is probed as a function of the accelerations along a parabola y(τ) = y + ẏ τ + ½ ÿ τ², by difference
// quotients, and minimised. No Jacobian, metric or Christoffel symbol.

#include <functional>

#include "gauss/oracle/real.hpp"

namespace gaussgen::oracle {

struct BareSystem {
  std::size_t free_count = 0;  ///< y holds the free coordinates, then the held ones
  Vec y, rate;
  Vec held_acceleration;  ///< c̈
  Real t = 0;
  Vec mass;
  std::function<std::vector<Vec3>(const Vec& y, const Real& t)> positions;
  Vec3 field{0, 0, 0};                                                           ///< gravity
  std::function<Real(const Vec& y, const Real& t)> potential;                    ///< may be empty
  Vec generalized;                                                               ///< further Q_A; may be empty
  std::function<Vec(const Vec& y, const Vec& rate, const Real& t)> constraints;  ///< φ_μ; may be empty
};

/// Velocities of the mass points, and their accelerations at the given ÿ.
std::vector<Vec3> velocities(const BareSystem& system);
std::vector<Vec3> accelerations(const BareSystem& system, const Vec& acceleration);

/// ∂r/∂y^A of the mass points.
std::vector<Vec3> displacements(const BareSystem& system, std::size_t A);

/// Kinetic energy; potential energy, the uniform field included.
Real kinetic_energy(const BareSystem& system);
Real potential_energy(const BareSystem& system);

/// Z = ½ ÿᵀ G ÿ + linearᵀ ÿ + rest and φ̇ = β ÿ + drift, probed.
struct Probe {
  Mat G;
  Vec linear;
  Real rest;
  Mat beta;
  Vec drift;
};

struct Motion {
  Vec accelerations;  ///< free ones
  Vec lambda;
  Vec R_x;
};

Probe probe(const BareSystem& system);

/// Least Z with φ̇ = 0 and ẍ = c̈; multipliers and reactions are the gradient that is left.
Motion minimise(const BareSystem& system, const Probe& probe);

}  // namespace gaussgen::oracle
