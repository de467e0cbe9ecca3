// What forces, or impulses, along rows do to the speeds, and along each other.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_COUPLINGS_HPP
#define GAUSS_EVENT_COUPLINGS_HPP

#include <cstddef>
#include <vector>

#include "gauss/event/dense.hpp"

namespace gauss::event {

/// Rows stand one after another and are gradients by the speeds; the metric is speeds × speeds.
template <class S>
struct Couplings {
  DenseMatrix<S> responses;  ///< row k: metric⁻¹ rowᵀ
  DenseMatrix<S> between;    ///< (k, j): of row k, from one unit along row j

  Couplings(const std::vector<S>& metric, const std::vector<S>& rows, std::size_t speeds, std::size_t count)
      : responses(count, speeds), between(count, count) {
    // In speeds whose inertia is 1: of lengths and angles, one may be small in its unit.
    DenseMatrix<S> matrix(speeds, speeds);
    std::vector<S> scales;
    for (std::size_t i = 0; i < speeds; ++i) {
      const S own = metric[i * speeds + i];
      scales.push_back(own > S(0) ? S(S(1) / Math<S>::sqrt(own)) : S(1));
    }
    for (std::size_t i = 0; i < speeds; ++i)
      for (std::size_t j = 0; j < speeds; ++j) matrix(i, j) = scales[i] * metric[i * speeds + j] * scales[j];
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<S> row(speeds);
      for (std::size_t i = 0; i < speeds; ++i) row[i] = scales[i] * rows[k * speeds + i];
      const std::vector<S> found = solve_dense(matrix, std::move(row));
      for (std::size_t i = 0; i < speeds; ++i) responses(k, i) = scales[i] * found[i];
    }
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t j = 0; j < count; ++j)
        for (std::size_t i = 0; i < speeds; ++i) between(k, j) += rows[k * speeds + i] * responses(j, i);
  }
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_COUPLINGS_HPP
