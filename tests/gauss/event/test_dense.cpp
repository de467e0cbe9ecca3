// Small dense systems: with full pivots, whatever their rank.

#include <cmath>
#include <random>

#include "catch_shim.hpp"
#include "gauss/event/dense.hpp"

using gauss::event::DenseMatrix;
using gauss::event::solve_dense;

namespace {

DenseMatrix<double> matrix_of(std::size_t n, const std::vector<double>& entries) {
  DenseMatrix<double> result(n, n);
  result.entries = entries;
  return result;
}

std::vector<double> product(const DenseMatrix<double>& matrix, const std::vector<double>& x) {
  std::vector<double> result(matrix.rows, 0);
  for (std::size_t i = 0; i < matrix.rows; ++i)
    for (std::size_t j = 0; j < matrix.columns; ++j) result[i] += matrix(i, j) * x[j];
  return result;
}

}  // namespace

TEST_CASE("a system of no equations has no unknowns", "[event]") {
  CHECK(solve_dense(DenseMatrix<double>(0, 0), {}).empty());
}

TEST_CASE("zeros on the diagonal need pivots", "[event]") {
  const std::vector<double> x = solve_dense(matrix_of(3, {0, 2, 0, 0, 0, 4, 8, 0, 0}), {1, 2, 3});
  CHECK(x[0] == 3.0 / 8);
  CHECK(x[1] == 0.5);
  CHECK(x[2] == 0.5);
}

TEST_CASE("random systems are solved to rounding", "[event]") {
  std::mt19937 random(20240607);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 1 + static_cast<std::size_t>(round) % 9;
    DenseMatrix<double> matrix(n, n);
    for (double& one : matrix.entries) one = entry(random);
    for (std::size_t i = 0; i < n; ++i)
      matrix(i, (i + 3) % n) += 4;  // away from singular ones, and not on the diagonal
    std::vector<double> right(n);
    for (double& one : right) one = entry(random);
    const std::vector<double> x = solve_dense(matrix, right), found = product(matrix, x);
    for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(found[i] - right[i]) < 1e-13);
  }
}

TEST_CASE("what depends on others is left at 0, and the rest solves the system", "[event]") {
  // The third is the sum of the first two, on both sides.
  const DenseMatrix<double> matrix = matrix_of(3, {2, 1, 3, 1, 3, 4, 3, 4, 7});
  const std::vector<double> right{1, 2, 3}, x = solve_dense(matrix, right), found = product(matrix, x);
  CHECK((x[0] == 0 || x[1] == 0 || x[2] == 0));
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(found[i] - right[i]) < 1e-14);
}

TEST_CASE("scales of equations far from 1 are no lack of rank", "[event]") {
  for (const double scale : {1e-200, 1e200}) {
    const std::vector<double> x =
        solve_dense(matrix_of(2, {2 * scale, scale, scale, 3 * scale}), {3 * scale, 4 * scale});
    CHECK(std::abs(x[0] - 1) < 1e-15);
    CHECK(std::abs(x[1] - 1) < 1e-15);
  }
}

TEST_CASE("in float and long double they have that many digits", "[event]") {
  DenseMatrix<float> in_float(2, 2);
  in_float.entries = {4, 1, 1, 3};
  CHECK(std::abs(solve_dense(in_float, {1, 2})[0] - 1.0F / 11) < 2e-8F);
  DenseMatrix<long double> in_long(2, 2);
  in_long.entries = {4, 1, 1, 3};
  CHECK(std::abs(solve_dense(in_long, {1, 2})[1] - 7.0L / 11) < 1e-19L);
}
