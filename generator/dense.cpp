#include "dense.hpp"

namespace Eigen {

template class JacobiSVD<MatrixXd>;
template class ColPivHouseholderQR<MatrixXd>;
template class CompleteOrthogonalDecomposition<MatrixXd>;

}  // namespace Eigen
