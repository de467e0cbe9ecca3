#include <cmath>

#include "catch_shim.hpp"
#include "support/assert.hpp"
#include "support/rational.hpp"

using namespace gaussgen::support;

namespace {

Rational ratio(int top, int bottom) { return Rational(top) / bottom; }

}  // namespace

TEST_CASE("a rational prints in lowest terms with its sign in front") {
  CHECK(to_text(ratio(4, -10)) == "-2/5");
  CHECK(to_text(ratio(6, 3)) == "2");
  CHECK(to_text(0) == "0");
}

TEST_CASE("long integers keep their inner zeros") {
  CHECK(to_text(cln::expt_pos(Integer(10), 30) + 7) == "1000000000000000000000000000007");
}

TEST_CASE("a rational beyond double becomes infinite or zero and never throws") {
  const Rational huge = cln::expt_pos(Integer(10), 400);
  CHECK(std::isinf(to_double(huge)));
  CHECK(to_double(-huge) < 0);
  CHECK(to_double(1 / huge) == 0.0);
}

TEST_CASE("a tenth becomes the nearest double") { CHECK(to_double(ratio(1, 10)) == 0.1); }

TEST_CASE("an integer that does not fit an int is an internal error") {
  CHECK(to_int(-7) == -7);
  CHECK_THROWS_AS(to_int(ratio(1, 2)), InternalError);
  CHECK_THROWS_AS(to_int(cln::expt_pos(Integer(10), 12)), InternalError);
}

TEST_CASE("equal rationals have equal hashes") {
  CHECK(hash(ratio(2, 4)) == hash(ratio(1, 2)));
  CHECK(hash(ratio(1, 2)) != hash(ratio(1, 3)));
}
