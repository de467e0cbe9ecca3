#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "catch_shim.hpp"
#include "formulas.hpp"

namespace mp = boost::multiprecision;

TEST_CASE("emitted code in cpp_bin_float_50 needs no adapter and keeps 50 digits") {
  // Numbers in three pieces are good for 159 bits, cpp_bin_float_50 has 168.
  CHECK(gausstest::largest_error<mp::cpp_bin_float_50>() < 64 * 512);
}

TEST_CASE("emitted code works with expression templates") {
  using Lazy = mp::number<mp::cpp_bin_float<40>, mp::et_on>;
  CHECK(gausstest::largest_error<Lazy>() < 64);
}
