#include <limits>

#include "catch_shim.hpp"
#include "sim/ensemble/statistics.hpp"

TEST_CASE("statistics of a few numbers are those by hand") {
  const auto some = gausssim::statistics_of({4, 1, 3, 2});
  CHECK(some.count == 4);
  CHECK(some.mean == 2.5);
  CHECK(some.deviation == Approx(std::sqrt(5.0 / 3)));
  CHECK(some.least == 1);
  CHECK(some.most == 4);
  CHECK(some.quantiles[0] == Approx(1.15));
  CHECK(some.quantiles[1] == 1.75);
  CHECK(some.quantiles[2] == 2.5);
  CHECK(some.quantiles[4] == Approx(3.85));
}

TEST_CASE("one number and none have statistics, too") {
  CHECK(gausssim::statistics_of({}).count == 0);
  const auto one = gausssim::statistics_of({7});
  CHECK(one.mean == 7);
  CHECK(one.deviation == 0);
  CHECK(one.quantiles[0] == 7);
  CHECK(one.quantiles[4] == 7);
}

TEST_CASE("a small deviation of large numbers keeps its digits") {
  const auto large = gausssim::statistics_of({1e9 + 1, 1e9 + 2, 1e9 + 3});
  CHECK(large.deviation == Approx(1).epsilon(1e-12));
}
