#pragma once
// Where the energy and the Jacobian of an emitted header are, number by number.

#include "emit/cpp_tree.hpp"
#include "sim/drive/functions.hpp"

namespace gausssim {

/// Size 0 where the header has none.
EnergyLayout energy_layout_of(const gaussgen::emit::cpp::File& tree);
JacobianLayout jacobian_layout_of(const gaussgen::emit::cpp::File& tree);

}  // namespace gausssim
