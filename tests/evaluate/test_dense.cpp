#include <cln/real.h>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/decimal.hpp"
#include "evaluate/dense.hpp"

namespace {

using namespace gaussgen::evaluate;
using cln::cl_F;

const Arithmetic<cl_F> k_arithmetic(50);

cl_F number(const Rational& value) { return k_arithmetic.number(value); }

Matrix hilbert(std::size_t n) {
  Matrix a(n, n, number(0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) a(i, j) = number(Rational(1) / static_cast<int>(i + j + 1));
  }
  return a;
}

Matrix rows(const std::vector<std::vector<int>>& entries) {
  Matrix a(entries.size(), entries[0].size(), number(0));
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < a.columns(); ++j) a(i, j) = number(entries[i][j]);
  }
  return a;
}

TEST_CASE("an ill-conditioned system is solved to its digits", "[evaluate]") {
  const Matrix a = hilbert(8);
  const Vector ones(8, number(1));
  const auto x = solve(a, multiply(a, ones));
  REQUIRE(x.has_value());
  for (const cl_F& entry : *x) CHECK(to_double(cln::abs(entry - number(1))) < 1e-45);
  CHECK(to_double(backward_error(a, *x, multiply(a, ones))) < 1e-58);
}

TEST_CASE("full pivoting needs no luck with zeros", "[evaluate]") {
  const Matrix a = rows({{0, 2, 0}, {0, 0, -3}, {5, 0, 0}});
  const auto x = solve(a, {number(4), number(6), number(15)});
  REQUIRE(x.has_value());
  CHECK(to_double((*x)[0]) == 3);
  CHECK(to_double((*x)[1]) == 2);
  CHECK(to_double((*x)[2]) == -2);
}

TEST_CASE("a singular system is refused and its rank known", "[evaluate]") {
  const Matrix a = rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  CHECK_FALSE(solve(a, Vector(3, number(1))).has_value());
  CHECK(rank(a, number(Rational(1) / 1000000)) == 2);
  CHECK(rank(rows({{0, 0}, {0, 0}}), number(Rational(1) / 1000000)) == 0);
  CHECK_FALSE(condition(a).has_value());
}

TEST_CASE("unknowns are open whose columns depend on others", "[evaluate]") {
  const cl_F tolerance = number(Rational(1) / 1000000);
  using Open = std::vector<std::size_t>;
  CHECK(open_unknowns(rows({{1, 0, 0}, {0, 1, 1}}), tolerance) == Open{1, 2});
  CHECK(open_unknowns(rows({{1, 2, 3}, {0, 1, 1}, {0, 0, 5}}), tolerance).empty());
  CHECK(open_unknowns(rows({{1, 2, 0, 0}, {2, 4, 0, 0}, {0, 0, 7, 0}}), tolerance) == Open{0, 1, 3});
  CHECK(open_unknowns(rows({{0, 0}, {0, 0}}), tolerance) == Open{0, 1});
  // x = y = -z, with each column once in front.
  CHECK(open_unknowns(rows({{9, -9, 0}, {0, 2, 2}, {3, 0, 3}}), tolerance) == Open{0, 1, 2});
}

TEST_CASE("elimination of many rows that are mostly zero", "[evaluate]") {
  // A chain of differences with one row twice: x_i - x_(i+1) = -1.
  const std::size_t n = 60;
  Matrix a(n + 1, n + 1, number(0));
  for (std::size_t i = 0; i < n; ++i) {
    a(i, i) = number(1);
    a(i, i + 1) = number(-1);
  }
  a(n, 7) = number(1);
  a(n, 8) = number(-1);
  CHECK(rank(a, number(Rational(1) / 1000000)) == n);
  CHECK(open_unknowns(a, number(Rational(1) / 1000000)).size() == n + 1);
  a(n, 8) = number(0);
  Vector b(n + 1, number(-1));
  b[n] = number(7);
  const auto x = solve(a, b);
  REQUIRE(x.has_value());
  for (std::size_t i = 0; i <= n; ++i) CHECK(to_double((*x)[i]) == static_cast<double>(i));
}

TEST_CASE("condition numbers agree with the literature", "[evaluate]") {
  // Hilbert matrices of order 5 and 8 (Todd 1954).
  CHECK(to_decimal(*condition(hilbert(5)), 6) == "476607");
  CHECK(to_decimal(*condition(hilbert(8)), 4) == "1.526e+10");
  CHECK(to_double(*condition(rows({{3, 0}, {0, -4}}))) == Approx(4.0 / 3.0));
}

TEST_CASE("singular values are those of the transpose too", "[evaluate]") {
  const Matrix a = rows({{1, 2}, {3, 4}, {5, 6}});
  const Vector values = singular_values(a);
  const Vector mirrored = singular_values(transposed(a));
  REQUIRE(values.size() == 2);
  // product of the singular values: sqrt(det(AᵀA)) = sqrt(24); sum of the squares: 91
  CHECK(to_double(cln::abs(values[0] * values[1] - cln::sqrt(number(24)))) < 1e-55);
  CHECK(to_double(cln::abs(cln::square(values[0]) + cln::square(values[1]) - number(91))) < 1e-55);
  CHECK(to_double(cln::abs(values[1] - mirrored[1])) < 1e-55);
}

TEST_CASE("scaling takes units out of the condition number", "[evaluate]") {
  const Matrix a = rows({{1000000, 1000}, {1000, 2}});
  CHECK(to_double(*condition(a)) > 1e5);
  CHECK(to_double(*condition(scaled_symmetric(a))) < 10);
  const Matrix even = equilibrated(rows({{1000, 0}, {1, 1}}));
  CHECK(to_double(*condition(even)) < 3);
}

TEST_CASE("backward error sees a wrong component however small its row", "[evaluate]") {
  const Matrix a = rows({{1000000, 0}, {0, 1}});
  const Vector b{number(1000000), number(1)};
  CHECK(to_double(backward_error(a, {number(1), number(1)}, b)) == 0);
  CHECK(to_double(backward_error(a, {number(1), number(3)}, b)) == Approx(0.5));
}

}  // namespace
