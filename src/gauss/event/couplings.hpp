// What forces, or impulses, along rows do to the speeds, and along each other.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_COUPLINGS_HPP
#define GAUSS_EVENT_COUPLINGS_HPP

#include <algorithm>
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
    DenseMatrix<S> matrix(speeds, speeds);
    matrix.entries = metric;
    for (std::size_t k = 0; k < count; ++k) {
      const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(k * speeds);
      const std::vector<S> found =
          solve_dense(matrix, std::vector<S>(begin, begin + static_cast<std::ptrdiff_t>(speeds)));
      std::copy(found.begin(), found.end(), responses.entries.begin() + static_cast<std::ptrdiff_t>(k * speeds));
    }
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t j = 0; j < count; ++j)
        for (std::size_t i = 0; i < speeds; ++i) between(k, j) += rows[k * speeds + i] * responses(j, i);
  }
};

}  // namespace gauss::event

#endif  // GAUSS_EVENT_COUPLINGS_HPP
