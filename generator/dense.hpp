#pragma once
// Decompositions of Eigen that several files use, compiled once (dense.cpp): each file that compiles one of its own takes six seconds longer.

#include <Eigen/Dense>

namespace Eigen {

extern template class JacobiSVD<MatrixXd>;
extern template class ColPivHouseholderQR<MatrixXd>;
extern template class CompleteOrthogonalDecomposition<MatrixXd>;

}  // namespace Eigen
