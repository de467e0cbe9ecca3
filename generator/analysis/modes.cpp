#include "analysis/modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "analysis/balance.hpp"
#include "analysis/blocks.hpp"

namespace gaussgen::analysis {

namespace {

constexpr Real k_rank = 1e-13L;      ///< of the largest singular value
constexpr Real k_shared = 1e-12L;    ///< of the largest entry: an eigenvalue that others have, too
constexpr Real k_rounding = 1e-17L;  ///< of the matrix that eigenvalues are of
constexpr Real k_part = 1e-15L;      ///< of a complex number, its real or imaginary part
constexpr Real k_same = 1e-12L;      ///< relative: real parts of conjugate ones and the like, for their order

using Indices = std::vector<std::size_t>;

/// Orthonormal columns that span what `a` makes.
Matrix range_of(const Matrix& a) {
  Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeThinU);
  svd.setThreshold(k_rank);
  return svd.matrixU().leftCols(svd.rank());
}

/// How far, to first order, each eigenvalue goes for a change of the matrix by 1: |x| |y| of its right and left eigenvector, with y x = 1
/// (Golub & Van Loan, Matrix Computations, 7.2.2). A double one goes as the root of the change, which sets the limit.
Vector conditions_of(const ComplexMatrix& right) {
  const Real most = 1 / std::sqrt(k_rounding);
  const Eigen::FullPivLU<ComplexMatrix> solver(right);
  if (!solver.isInvertible()) return Vector::Constant(right.cols(), most);
  const ComplexMatrix left = solver.inverse();
  Vector conditions(right.cols());
  for (Eigen::Index k = 0; k < right.cols(); ++k)
    conditions[k] = std::min(most, std::max<Real>(1, left.row(k).norm() * right.col(k).norm()));
  return conditions;
}

/// a over the range of its powers: the eigenvalues other than 0, which would be roots of rounding if there are several.
struct Core {
  Matrix matrix;
  Matrix basis;
};

Core core_of(const Matrix& a) {
  Core core{a, Matrix::Identity(a.rows(), a.cols())};
  while (core.matrix.rows() > 0) {
    const Matrix range = range_of(core.matrix);
    if (range.cols() == core.matrix.cols()) break;
    core.basis = (core.basis * range).eval();
    core.matrix = (range.transpose() * core.matrix * range).eval();
  }
  return core;
}

class Finder {
 public:
  explicit Finder(const Matrix& a) : a_(a), blocks_(blocks(a_)) {}

  std::vector<Mode> run() {
    for (std::size_t b = 0; b < blocks_.size(); ++b) add_block(b);
    std::stable_sort(modes_.begin(), modes_.end(), comes_before);
    return std::move(modes_);
  }

 private:
  void add_block(std::size_t b) {
    const Indices& block = blocks_[b];
    const Matrix own = part(a_, block, block);
    const Vector d = balance(own);
    const Matrix balanced = d.cwiseInverse().asDiagonal() * own * d.asDiagonal();
    const Core core = core_of(balanced);
    if (core.matrix.rows() > 0) {
      const Eigen::EigenSolver<Matrix> solver(core.matrix);
      const Vector conditions = conditions_of(solver.eigenvectors());
      for (Eigen::Index k = 0; k < core.matrix.rows(); ++k) {
        const ComplexVector shape =
            d.cast<Complex>().asDiagonal() * (core.basis.cast<Complex>() * solver.eigenvectors().col(k)).eval();
        const Complex s = without_rounding(solver.eigenvalues()[k], conditions[k] * balanced.norm());
        modes_.push_back({s, s == Complex(0) ? ComplexVector() : followed(b, s, shape), block});
      }
    }
    for (auto k = static_cast<std::size_t>(core.matrix.rows()); k < block.size(); ++k)
      modes_.push_back({Complex(0), {}, block});
  }

  /// With what the others make of it: (s - A_cc) v_c = Σ A_cd v_d of earlier blocks d. A block that has this eigenvalue itself grows
  /// beyond the exponential, and is left at rest.
  ComplexVector followed(std::size_t b, const Complex& s, const ComplexVector& own) const {
    ComplexVector shape = ComplexVector::Zero(a_.rows());
    const Complex unit = largest_of(own);
    for (std::size_t i = 0; i < blocks_[b].size(); ++i) {
      shape[static_cast<Eigen::Index>(blocks_[b][i])] = without_rounding(own[static_cast<Eigen::Index>(i)] / unit, 1);
    }
    for (std::size_t c = b + 1; c < blocks_.size(); ++c) {
      const Indices& block = blocks_[c];
      const auto size = static_cast<Eigen::Index>(block.size());
      ComplexVector drive(size);
      for (Eigen::Index i = 0; i < size; ++i)
        drive[i] = a_.row(static_cast<Eigen::Index>(block[static_cast<std::size_t>(i)])).cast<Complex>() * shape;
      if (drive.isZero(0)) continue;
      const ComplexMatrix own_part = part(a_, block, block).cast<Complex>();
      const Real scale = std::max(own_part.cwiseAbs().maxCoeff(), std::abs(s));
      Eigen::FullPivLU<ComplexMatrix> solver(s * ComplexMatrix::Identity(size, size) - own_part);
      const Real least = std::abs(solver.matrixLU()(size - 1, size - 1));
      if (!(least > k_shared * scale)) continue;
      const ComplexVector found = solver.solve(drive);
      for (Eigen::Index i = 0; i < size; ++i)
        shape[static_cast<Eigen::Index>(block[static_cast<std::size_t>(i)])] = found[i];
    }
    return shape;
  }

  /// An oscillation without damping has no real part, and neither has the other an imaginary one.
  static Complex without_rounding(const Complex& s, Real size) {
    const Real nothing = std::max(k_rounding * size, k_part * std::abs(s));
    return {std::abs(s.real()) <= nothing ? 0 : s.real(), std::abs(s.imag()) <= nothing ? 0 : s.imag()};
  }

  static Complex largest_of(const ComplexVector& v) {
    Complex largest = 0;
    // The first of those that are equal up to rounding.
    for (const Complex& entry : v) {
      if (std::abs(entry) > std::abs(largest) * (1 + k_same)) largest = entry;
    }
    return largest;
  }

  static bool comes_before(const Mode& one, const Mode& other) {
    const bool one_is_zero = one.shape.size() == 0, other_is_zero = other.shape.size() == 0;
    if (one_is_zero || other_is_zero) return !one_is_zero && other_is_zero;
    const Complex a = one.eigenvalue, b = other.eigenvalue;
    const Real same = k_same * std::max(std::abs(a), std::abs(b));
    if (std::abs(a.real() - b.real()) > same) return a.real() > b.real();
    if (std::abs(std::abs(a.imag()) - std::abs(b.imag())) > same) return std::abs(a.imag()) < std::abs(b.imag());
    return a.imag() > b.imag() + same;
  }

  Matrix a_;
  std::vector<Indices> blocks_;
  std::vector<Mode> modes_;
};

}  // namespace

std::vector<Mode> modes(const Matrix& a) { return Finder(a).run(); }

}  // namespace gaussgen::analysis
