#pragma once
// What acts on a moving model: forces at places, forces along coordinates, and what its constraints say.

#include "newton/course.hpp"

namespace agreement::newton {

/// A force with its moment about `point`, on what is fixed in a frame, in space.
struct Load {
  std::size_t frame = gaussgen::model::k_space;
  Vector3 point;
  Vector3 force;
  Vector3 moment;
  bool has_potential = false;
  const gaussgen::model::Body* body = nullptr;  ///< of a field, which acts on each mass by itself
};

/// Every force of the model that is somewhere.
std::vector<Load> loads(const gaussgen::model::Model& model, Motion& motion);

/// A sum with the sizes of its terms, by which its rounding is to be judged.
struct Sum {
  Real value = 0;
  Real size = 0;

  void add(Real term) {
    value += term;
    size += functions::fabs(term);
  }
  void add(const Sum& other, Real factor = 1) {
    value += factor * other.value;
    size += functions::fabs(factor) * other.size;
  }
};

/// Work of a load along a displacement.
Sum work(const Load& load, Motion& displaced);

/// Work of inertia: m a along the mass centres and dH/dt along the turns; of one body.
Sum work_of_inertia(const gaussgen::model::Body& body, Motion& motion, Motion& displaced);

/// dH/dt about the mass centre of a rigid body, H = R I Rᵀ ω in space.
Vector3 rate_of_spin(const gaussgen::model::Body& body, Motion& motion);
Matrix3 inertia(const gaussgen::model::Body& body, Motion& motion);

/// Work of the forces along coordinates: generalized forces, springs along a coordinate, potentials.
struct WorkAlong {
  Sum of_potentials;
  Sum others;  ///< dampers of springs included
};
WorkAlong work_along_coordinates(const gaussgen::model::Model& model, Motion& motion, Motion& displaced);

/// What the model stores.
struct Energy {
  Sum kinetic;
  Sum potential;
  Sum explicit_power;  ///< dV/dt at rest: of potentials, stiffnesses, lengths and fields that change in time
};
Energy energy(const gaussgen::model::Model& model, Motion& motion, Motion& time);

/// φ and dφ/dt.
Number phi(const gaussgen::model::Constraint& constraint, Motion& motion);

/// ∂φ/∂v of what the constraint acts on: a load for a multiplier of 1.
std::vector<Load> actions(const gaussgen::model::Model& model, const gaussgen::model::Constraint& constraint,
                          Motion& motion);

}  // namespace agreement::newton
