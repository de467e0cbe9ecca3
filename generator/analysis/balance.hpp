#pragma once

#include "analysis/matrix.hpp"

namespace gaussgen::analysis {

/// d with D^-1 a D of rows and columns of like size, powers of two, so that nothing is rounded: eigenvalues of a matrix in which
/// metres stand beside radians and newtons keep their digits (Parlett and Reinsch, Numer. Math. 13 (1969) 293-304).
Vector balance(const Matrix& a);

}  // namespace gaussgen::analysis
