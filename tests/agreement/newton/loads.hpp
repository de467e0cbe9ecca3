#pragma once
// What acts on a moving model: forces at places, forces along coordinates, and what its constraints say.

#include "newton/course.hpp"

namespace agreement::newton {

/// A force with its moment about `point`, on what is fixed in a frame, in space.
struct Load {
  std::size_t frame = gaussgen::model::k_space;
  Eigen::Vector3d point;
  Eigen::Vector3d force;
  Eigen::Vector3d moment;
  bool has_potential = false;
  const gaussgen::model::Body* body = nullptr;  ///< of a field, which acts on each mass by itself
};

/// Every force of the model that is somewhere.
std::vector<Load> loads(const gaussgen::model::Model& model, Motion& motion);

/// A sum with the sizes of its terms, by which its rounding is to be judged.
struct Sum {
  double value = 0;
  double size = 0;

  void add(double term) {
    value += term;
    size += std::fabs(term);
  }
  void add(const Sum& other, double factor = 1) {
    value += factor * other.value;
    size += std::fabs(factor) * other.size;
  }
};

/// Work of a load along a displacement.
Sum work(const Load& load, Motion& displaced);

/// Work of inertia: m a along the mass centres and dH/dt along the turns; of one body.
Sum work_of_inertia(const gaussgen::model::Body& body, Motion& motion, Motion& displaced);

/// dH/dt about the mass centre of a rigid body, H = R I Rᵀ ω in space.
Eigen::Vector3d rate_of_spin(const gaussgen::model::Body& body, Motion& motion);
Eigen::Matrix3d inertia(const gaussgen::model::Body& body, Motion& motion);

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
