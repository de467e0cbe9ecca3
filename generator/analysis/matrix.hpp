#pragma once
// Numbers of linear analysis: some digits more than double shows.

#include <Eigen/Dense>
#include <complex>

namespace gaussgen::analysis {

using Real = long double;
using Complex = std::complex<Real>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using ComplexMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using ComplexVector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

}  // namespace gaussgen::analysis
