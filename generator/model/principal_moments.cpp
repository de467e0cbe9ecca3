#include "model/principal_moments.hpp"

#include <algorithm>
#include <cmath>

namespace gaussgen::model {

namespace {

/// Far more than the cyclic Jacobi method ever takes: it converges quadratically.
constexpr int k_most_sweeps = 30;

/// A rotation in the plane p, q that makes a_pq vanish (Golub & Van Loan, Matrix Computations, 8.5.2).
void rotate(Matrix3& a, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double tangent = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double cosine = 1 / std::hypot(tangent, 1.0);
  const double sine = tangent * cosine;
  for (auto& row : a) {
    const double left = row[p];
    row[p] = cosine * left - sine * row[q];
    row[q] = sine * left + cosine * row[q];
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const double upper = a[p][j];
    a[p][j] = cosine * upper - sine * a[q][j];
    a[q][j] = sine * upper + cosine * a[q][j];
  }
  a[p][q] = a[q][p] = 0;
}

}  // namespace

std::array<double, 3> principal_moments(Matrix3 inertia) {
  for (int sweep = 0; sweep < k_most_sweeps; ++sweep) {
    for (const std::size_t p : {0U, 1U}) {
      for (std::size_t q = p + 1; q < 3; ++q) rotate(inertia, p, q);
    }
  }
  std::array<double, 3> moments{inertia[0][0], inertia[1][1], inertia[2][2]};
  std::sort(moments.begin(), moments.end());
  return moments;
}

}  // namespace gaussgen::model
