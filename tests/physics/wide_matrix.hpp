#pragma once
// Matrices in more digits than what is under test.

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace physics {

using Wide = long double;
using Row = std::vector<Wide>;
using Matrix = std::vector<Row>;

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Empty where the matrix is singular: no pivot above `least`.
inline Matrix inverse(Matrix a, Wide least) {
  const std::size_t n = a.size();
  Matrix b(n, Row(n, 0));
  for (std::size_t i = 0; i < n; ++i) b[i][i] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t p = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[p][k])) p = i;
    if (!(std::abs(a[p][k]) > least)) return {};
    std::swap(a[p], a[k]);
    std::swap(b[p], b[k]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Wide factor = a[i][k] / a[k][k];
      for (std::size_t j = 0; j < n; ++j) a[i][j] -= factor * a[k][j], b[i][j] -= factor * b[k][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) b[i][j] /= a[i][i];
  return b;
}

inline Wide norm(const Matrix& a) {
  Wide squares = 0;
  for (const Row& row : a)
    for (const Wide entry : row) squares += entry * entry;
  return std::sqrt(squares);
}

}  // namespace physics
