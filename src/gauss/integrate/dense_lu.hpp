// Dense linear systems whose size is known at run time, factorised once and solved several times.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_DENSE_LU_HPP
#define GAUSS_INTEGRATE_DENSE_LU_HPP

#include <cstddef>
#include <utility>
#include <vector>

#include "gauss/integrate/state_arrays.hpp"

namespace gauss::integrate {

/// P A = L U with pivots of columns (Golub and Van Loan, Matrix Computations, 4th ed., 3.4.1).
template <class S>
class DenseLu {
 public:
  /// A matrix of zeros, to be filled by `at` before `factorise`.
  void begin(std::size_t size) {
    size_ = size;
    entries_.assign(size * size, S(0));
    row_.resize(size);
  }
  S& at(std::size_t i, std::size_t j) { return entries_[i * size_ + j]; }

  /// False: it is singular, or an entry is no number.
  bool factorise() {
    for (std::size_t i = 0; i < size_; ++i) row_[i] = i;
    for (std::size_t k = 0; k < size_; ++k) {
      std::size_t best = k;
      for (std::size_t i = k + 1; i < size_; ++i)
        if (magnitude(at(i, k)) > magnitude(at(best, k))) best = i;
      if (!(magnitude(at(best, k)) > S(0))) return false;
      if (best != k) {
        for (std::size_t j = 0; j < size_; ++j) std::swap(at(k, j), at(best, j));
        std::swap(row_[k], row_[best]);
      }
      eliminate_below(k);
    }
    return true;
  }

  /// x with A x = b.
  void solve(const std::vector<S>& b, std::vector<S>& x) const {
    x.resize(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      S sum = b[row_[i]];
      for (std::size_t j = 0; j < i; ++j) sum -= entries_[i * size_ + j] * x[j];
      x[i] = sum;
    }
    for (std::size_t i = size_; i-- > 0;) {
      S sum = x[i];
      for (std::size_t j = i + 1; j < size_; ++j) sum -= entries_[i * size_ + j] * x[j];
      x[i] = sum / entries_[i * size_ + i];
    }
  }

 private:
  void eliminate_below(std::size_t k) {
    const S* const pivot = entries_.data() + k * size_;
    for (std::size_t i = k + 1; i < size_; ++i) {
      S* const row = entries_.data() + i * size_;
      if (row[k] == S(0)) continue;
      const S factor = row[k] /= pivot[k];
      for (std::size_t j = k + 1; j < size_; ++j) row[j] -= factor * pivot[j];
    }
  }

  std::size_t size_ = 0;
  std::vector<S> entries_;  ///< row by row; L below the diagonal, and U
  std::vector<std::size_t> row_;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_DENSE_LU_HPP
