#pragma once
// Small dense linear algebra in CLN floats: the yardstick for emitted solvers. All entries share one precision, that of
// the numbers that are put in; a Matrix starts with zeros of the precision it is given.

#include <cln/float.h>

#include <optional>
#include <vector>

namespace gaussgen::evaluate {

using Vector = std::vector<cln::cl_F>;

class Matrix {
 public:
  /// Zeros in the precision of `like`.
  Matrix(std::size_t rows, std::size_t columns, const cln::cl_F& like)
      : rows_(rows), columns_(columns), entries_(rows * columns, cln::cl_float(0, like)) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  cln::cl_F& operator()(std::size_t i, std::size_t j) { return entries_[i * columns_ + j]; }
  const cln::cl_F& operator()(std::size_t i, std::size_t j) const { return entries_[i * columns_ + j]; }

 private:
  std::size_t rows_;
  std::size_t columns_;
  Vector entries_;
};

Matrix transposed(const Matrix& a);
Matrix multiply(const Matrix& a, const Matrix& b);
Vector multiply(const Matrix& a, const Vector& x);

/// x with A x = b for square A, by elimination with full pivoting; empty if A is singular in its precision.
std::optional<Vector> solve(const Matrix& a, const Vector& b);

/// Number of pivots above `tolerance` times the largest entry.
std::size_t rank(const Matrix& a, const cln::cl_F& tolerance);

/// Unknowns that A x = 0 leaves open, in order: those whose columns depend on others. Of columns of like size (`equilibrated`).
std::vector<std::size_t> open_unknowns(const Matrix& a, const cln::cl_F& tolerance);

/// Descending; one-sided Jacobi rotations, so that small ones keep their digits (AᵀA would lose half).
Vector singular_values(const Matrix& a);

/// Largest over smallest singular value; empty if the smallest is zero in the precision of A.
std::optional<cln::cl_F> condition(const Matrix& a);

/// D A D with D = diag(|a_ii|^(-1/2)): a mass matrix without its units. Rows with a zero on the diagonal stay.
Matrix scaled_symmetric(const Matrix& a);

/// Rows, then columns, divided by their largest entry; zero ones stay.
Matrix equilibrated(const Matrix& a);

/// Componentwise backward error of x as a solution of A x = b: max_i |b - A x|_i / (|A| |x| + |b|)_i (Oettli and
/// Prager). Rows that are zero throughout count as solved.
cln::cl_F backward_error(const Matrix& a, const Vector& x, const Vector& b);

}  // namespace gaussgen::evaluate
