#pragma once
// Eigenvalues of a symmetric 3×3 matrix. Private to the folder.

#include <array>

namespace gaussgen::model {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Ascending.
std::array<double, 3> principal_moments(Matrix3 inertia);

}  // namespace gaussgen::model
