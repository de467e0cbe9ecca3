#include "catch_shim.hpp"
#include "gauss/scalar/float128.hpp"

#include "formulas.hpp"

TEST_CASE("emitted code in __float128 agrees with formulas written by hand, to 113 bits") {
  CHECK(gausstest::largest_error<__float128>() < 64);
}

TEST_CASE("the constants of __float128 have all their digits") {
  using M = gauss::Math<__float128>;
  CHECK(M::pi() == M::acos(-1));
  CHECK(static_cast<__float128>(1) + M::epsilon() > 1);
  CHECK(static_cast<__float128>(1) + M::epsilon() / 2 == 1);
}
