// What a small dense matrix takes to 0.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_NULL_SPACE_HPP
#define GAUSS_EVENT_NULL_SPACE_HPP

#include <algorithm>
#include <cstddef>
#include <vector>

#include "gauss/event/dense.hpp"

namespace gauss::event {

/// Orthonormal vectors that span rows and, if they are wanted, what is across all of them.
template <class S>
class OrthonormalVectors {
 public:
  explicit OrthonormalVectors(std::size_t size) : size_(size) {}

  /// Of `candidates`, as long as one has a part across all so far that is longer than `least`: the longest first (Golub and Van Loan, Matrix Computations, 4th ed., 5.4.1).
  void add(std::vector<std::vector<S>> candidates, const S& least) {
    for (std::size_t count = candidates.size(); count > 0 && vectors.size() < size_; --count) {
      std::size_t best = 0;
      S longest = -1;
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        candidates[c] = across(std::move(candidates[c]));
        const S length = length_of(candidates[c]);
        if (length > longest) longest = length, best = c;
      }
      if (!(longest > least)) return;
      for (S& x : candidates[best]) x /= longest;
      vectors.push_back(candidates[best]);
    }
  }

  /// The part of a vector that is across all of these. (Twice is enough.)
  std::vector<S> across(std::vector<S> v) const {
    for (int again = 0; again < 2; ++again) remove_from(v);
    return v;
  }

  std::vector<std::vector<S>> vectors;

 private:
  void remove_from(std::vector<S>& v) const {
    for (const std::vector<S>& one : vectors) {
      const S part = product_of(one, v);
      for (std::size_t i = 0; i < size_; ++i) v[i] -= part * one[i];
    }
  }

  std::size_t size_;
};

/// Its columns are an orthonormal basis of all x with matrix x = 0; rows whose part across others is no longer than `least` follow from these.
template <class S>
DenseMatrix<S> null_space(const DenseMatrix<S>& matrix, const S& least) {
  const std::size_t n = matrix.columns;
  std::vector<std::vector<S>> rows, units;
  for (std::size_t i = 0; i < matrix.rows; ++i) {
    const auto begin = matrix.entries.begin() + static_cast<std::ptrdiff_t>(i * n);
    rows.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(n));
  }
  for (std::size_t j = 0; j < n; ++j) {
    units.emplace_back(n, S(0));
    units.back()[j] = S(1);
  }
  OrthonormalVectors<S> all(n);
  all.add(std::move(rows), least);
  const std::size_t rank = all.vectors.size();
  all.add(std::move(units), S(0));
  DenseMatrix<S> result(n, n - rank);
  for (std::size_t j = rank; j < all.vectors.size(); ++j)
    for (std::size_t i = 0; i < n; ++i) result(i, j - rank) = all.vectors[j][i];
  return result;
}

/// C with metric = C Cᵀ, of which the upper part is 0 (Golub and Van Loan, 4.2.5).
template <class S>
DenseMatrix<S> cholesky_factor(const std::vector<S>& metric, std::size_t speeds) {
  DenseMatrix<S> factor(speeds, speeds);
  for (std::size_t i = 0; i < speeds; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      S sum = metric[i * speeds + j];
      for (std::size_t k = 0; k < j; ++k) sum -= factor(i, k) * factor(j, k);
      factor(i, j) = i == j ? Math<S>::sqrt(sum) : S(sum / factor(j, j));
    }
  }
  return factor;
}

/// Row k is C⁻¹ rowᵀ: scalar products of these are those of rows in the inverse metric.
template <class S>
DenseMatrix<S> in_metric(const std::vector<S>& metric, const std::vector<S>& rows, std::size_t speeds,
                         std::size_t count) {
  const DenseMatrix<S> factor = cholesky_factor(metric, speeds);
  DenseMatrix<S> result(count, speeds);
  for (std::size_t r = 0; r < count; ++r) {
    for (std::size_t i = 0; i < speeds; ++i) {
      S sum = rows[r * speeds + i];
      for (std::size_t k = 0; k < i; ++k) sum -= factor(i, k) * result(r, k);
      result(r, i) = sum / factor(i, i);
    }
  }
  return result;
}

/// Speeds, of what is C⁻¹ of forces: C⁻ᵀ v.
template <class S>
std::vector<S> out_of_metric(const std::vector<S>& metric, std::vector<S> v) {
  const DenseMatrix<S> factor = cholesky_factor(metric, v.size());
  for (std::size_t i = v.size(); i-- > 0;) {
    for (std::size_t k = i + 1; k < v.size(); ++k) v[i] -= factor(k, i) * v[k];
    v[i] /= factor(i, i);
  }
  return v;
}

}  // namespace gauss::event

#endif  // GAUSS_EVENT_NULL_SPACE_HPP
