#include "analysis/modes.hpp"

#include <algorithm>

#include "analysis/balance.hpp"
#include "analysis/blocks.hpp"
#include "catch_shim.hpp"

using namespace gaussgen::analysis;

namespace {

using Indices = std::vector<std::size_t>;

double distance(const Complex& a, const Complex& b) { return static_cast<double>(std::abs(a - b)); }

}  // namespace

TEST_CASE("several zeros of a chain of integrators are zeros, not roots of rounding") {
  // Two masses on a spring, in a basis in which nothing is apart: zero twice, with one vector.
  Matrix a(4, 4);
  a << 0, 0, 1, 0, 0, 0, 0, 1, -3, 3, 0, 0, 3, -3, 0, 0;
  Matrix mix(4, 4);
  mix << 1, 0.3L, 0.1L, 0, 0.2L, 1, 0, 0.7L, 0, 0.1L, 1, 0.4L, 0.5L, 0, 0.3L, 1;
  const auto found = modes(mix * a * mix.inverse());
  REQUIRE(found.size() == 4);
  CHECK(distance(found[0].eigenvalue, {0, std::sqrt(6.0L)}) < 1e-16);
  CHECK(distance(found[1].eigenvalue, {0, -std::sqrt(6.0L)}) < 1e-16);
  for (const std::size_t k : {2U, 3U}) {
    CHECK(found[k].eigenvalue == Complex(0));
    CHECK(found[k].shape.size() == 0);
  }
}

TEST_CASE("what follows a motion is part of its mode, and does not make its eigenvalue") {
  // x' = -2 x; y' = x; z' = y + z, which grows by itself.
  Matrix a(3, 3);
  a << -2, 0, 0, 1, 0, 0, 0, 1, 1;
  const auto found = modes(a);
  CHECK(found[0].eigenvalue == Complex(1));
  CHECK(found[1].eigenvalue == Complex(-2));
  CHECK(found[2].eigenvalue == Complex(0));
  CHECK(found[1].makers == Indices{0});
  CHECK(distance(found[1].shape[0], 1) < 1e-18);
  CHECK(distance(found[1].shape[1], -0.5L) < 1e-18);
  CHECK(distance(found[1].shape[2], 0.5L / 3) < 1e-18);
}

TEST_CASE("a mode satisfies A v = s v, and its largest part is 1") {
  Matrix a(4, 4);
  a << -0.5L, 3, 0.2L, 0, -2, 0.1L, 0.7L, 1, 0.4L, -1, -3, 2, 0.3L, 0.6L, -5, 0.2L;
  for (const Mode& mode : modes(a)) {
    CHECK((a.cast<Complex>() * mode.shape - mode.eigenvalue * mode.shape).norm() < 1e-17L);
    CHECK(static_cast<double>(mode.shape.cwiseAbs().maxCoeff()) == Approx(1));
  }
}

TEST_CASE("eigenvalues keep their digits where units differ by ten orders") {
  Matrix a(2, 2);
  a << 0, 1e10L, 2e-10L, 1;
  const auto found = modes(a);
  CHECK(distance(found[0].eigenvalue, 2) < 1e-17);
  CHECK(distance(found[1].eigenvalue, -1) < 1e-17);
  const Vector d = balance(a);
  CHECK(static_cast<double>(1e10L * d[1] / d[0]) < 4);
}

TEST_CASE("blocks come after those on which they depend, and what has no effect is found also behind each other") {
  Matrix a = Matrix::Zero(5, 5);
  a(0, 1) = 1;            // 0 depends on 1,
  a(1, 3) = a(3, 1) = 1;  // which depends on 3 and back,
  a(4, 0) = 1;            // and 4 on 0; 2 stands alone
  CHECK(blocks(a) == std::vector<Indices>{{2}, {1, 3}, {0}, {4}});
  CHECK(without_effect(a, {true, true, true, true, true}) == Indices{0, 2, 4});
  CHECK(without_effect(a, {true, true, true, true, false}) == Indices{2});
}

TEST_CASE("what cancels leaves nothing") {
  Matrix a(1, 3), b(3, 1);
  a << 1e9L, 0.1L, -1e9L;
  b << 1, 0, 1 + 1e-19L;
  CHECK(product(a, b)(0, 0) == 0);
  b << 1, 1, 1;
  CHECK(product(a, b)(0, 0) != 0);
}

TEST_CASE(
    "nearly equal oscillations without damping have no real part: their eigenvalues move further than the matrix") {
  // One drives the other, whose frequency is 1e-5 higher, in a basis in which nothing is apart.
  Matrix a = Matrix::Zero(4, 4);
  a << 0, 1, 0, 0, -1, 0, 1, 0, 0, 0, 0, 1 + 1e-5L, 0, 0, -(1 + 1e-5L), 0;
  Matrix mix(4, 4);
  mix << 1, 0.3L, 0.1L, 0, 0.2L, 1, 0, 0.7L, 0, 0.1L, 1, 0.4L, 0.5L, 0, 0.3L, 1;
  for (const Mode& mode : modes(mix * a * mix.inverse())) CHECK(mode.eigenvalue.real() == 0);
  // What is larger than that stays.
  a -= 1e-9L * Matrix::Identity(4, 4);
  for (const Mode& mode : modes(mix * a * mix.inverse()))
    CHECK(static_cast<double>(mode.eigenvalue.real()) == Approx(-1e-9).epsilon(1e-3));
}
