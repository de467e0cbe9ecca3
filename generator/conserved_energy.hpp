#pragma once
// Whether the energy of a model stays what it is in every motion.

#include "mechanics.hpp"

namespace gaussgen {

/// By its energies. True where it follows from the form of the model: all forces have potentials that are part of the energy, constraints are linear and homogeneous in the speeds
/// (scleronomic, so that reactions do no work), nothing is a law in time. False does not say that energy changes.
bool conserves_energy(Mechanics& mechanics, ir::Expr kinetic, ir::Expr potential);

}  // namespace gaussgen
