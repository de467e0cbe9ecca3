// Small dense systems whose size is known at run time.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_DENSE_HPP
#define GAUSS_EVENT_DENSE_HPP

#include <cstddef>
#include <utility>
#include <vector>

#include "gauss/math.hpp"

namespace gauss::event {

template <class S>
S magnitude_of(const S& x) {
  return x < S(0) ? -x : x;
}

template <class S>
S product_of(const std::vector<S>& a, const std::vector<S>& b) {
  S sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

template <class S>
S length_of(const std::vector<S>& v) {
  return Math<S>::sqrt(product_of(v, v));
}

template <class S>
std::vector<S> in_one_direction(std::vector<S> v) {
  const S length = length_of(v);
  for (S& one : v) one /= length;
  return v;
}

/// Row by row.
template <class S>
struct DenseMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<S> entries;

  DenseMatrix() = default;
  DenseMatrix(std::size_t of_rows, std::size_t of_columns)
      : rows(of_rows), columns(of_columns), entries(of_rows * of_columns, S(0)) {}

  S& operator()(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
  const S& operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};

/// x with matrix x = right, by Gaussian elimination with pivots over rows and columns (Golub and Van Loan, Matrix Computations, 4th ed., 3.4.8).
/// What depends on others up to rounding is left at 0.
template <class S>
std::vector<S> solve_dense(DenseMatrix<S> matrix, std::vector<S> right) {
  const std::size_t n = matrix.rows;
  std::vector<std::size_t> column(n);
  for (std::size_t i = 0; i < n; ++i) column[i] = i;
  S largest = 0;
  for (const S& entry : matrix.entries)
    if (largest < magnitude_of(entry)) largest = magnitude_of(entry);
  const S least = S(n) * 16 * Math<S>::epsilon() * largest;
  std::size_t rank = 0;
  for (; rank < n; ++rank) {
    std::size_t best_row = rank, best_column = rank;
    for (std::size_t i = rank; i < n; ++i)
      for (std::size_t j = rank; j < n; ++j)
        if (magnitude_of(matrix(best_row, best_column)) < magnitude_of(matrix(i, j))) best_row = i, best_column = j;
    if (!(least < magnitude_of(matrix(best_row, best_column)))) break;
    for (std::size_t j = 0; j < n; ++j) std::swap(matrix(rank, j), matrix(best_row, j));
    std::swap(right[rank], right[best_row]);
    for (std::size_t i = 0; i < n; ++i) std::swap(matrix(i, rank), matrix(i, best_column));
    std::swap(column[rank], column[best_column]);
    for (std::size_t i = rank + 1; i < n; ++i) {
      const S factor = matrix(i, rank) / matrix(rank, rank);
      for (std::size_t j = rank; j < n; ++j) matrix(i, j) -= factor * matrix(rank, j);
      right[i] -= factor * right[rank];
    }
  }
  std::vector<S> result(n, S(0));
  for (std::size_t i = rank; i-- > 0;) {
    S sum = right[i];
    for (std::size_t j = i + 1; j < rank; ++j) sum -= matrix(i, j) * result[column[j]];
    result[column[i]] = sum / matrix(i, i);
  }
  return result;
}

}  // namespace gauss::event

#endif  // GAUSS_EVENT_DENSE_HPP
