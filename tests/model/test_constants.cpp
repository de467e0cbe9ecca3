#include "building.hpp"
#include "catch_shim.hpp"

using test::Built;
using test::with;

namespace {

std::string codes_of_potential(const std::string& expression) {
  return Built(with("forces: {f: {potential: \"x*" + expression + "\"}}\n")).codes();
}

}  // namespace

TEST_CASE("a division by what is exactly zero is refused") {
  CHECK(codes_of_potential("1/0") == "E053");
  CHECK(codes_of_potential("1/(0.1 + 0.2 - 0.3)") == "E053");
  CHECK(codes_of_potential("0^-1") == "E053");
  CHECK(codes_of_potential("1/(0.1 + 0.2 - 0.29)").empty());
}

TEST_CASE("a division by what rounding hides is refused too") {
  CHECK(codes_of_potential("1/sin(pi)") == "E053");
  CHECK(codes_of_potential("1/cos(pi/2)") == "E053");
  CHECK(codes_of_potential("tan(pi/2)") == "E053");
  CHECK(codes_of_potential("tan(pi/4)").empty());
}

TEST_CASE("functions outside their real domain are refused") {
  CHECK(codes_of_potential("log(0)") == "E053");
  CHECK(codes_of_potential("log(-1)") == "E053");
  CHECK(codes_of_potential("sqrt(-2)") == "E053");
  CHECK(codes_of_potential("sqrt(1 - pi)") == "E053");
  CHECK(codes_of_potential("asin(2)") == "E053");
  CHECK(codes_of_potential("acos(-1.5)") == "E053");
  CHECK(codes_of_potential("atan2(0, 0)") == "E053");
  CHECK(codes_of_potential("(-8)^(1/3)") == "E053");
  CHECK(codes_of_potential("asin(1)").empty());
  CHECK(codes_of_potential("sqrt(0)").empty());
  CHECK(codes_of_potential("log(2)").empty());
  CHECK(codes_of_potential("(-8)^3").empty());
}

TEST_CASE("numbers that meet beyond the range of double are refused") {
  CHECK(codes_of_potential("1e300*1e300") == "E054");
  CHECK(codes_of_potential("1e-300*1e-300") == "E054");
  CHECK(codes_of_potential("exp(1000)") == "E054");
  CHECK(codes_of_potential("1e300").empty());
}

TEST_CASE("one range holds for numbers however they are written") {
  for (const char* const inside : {"1e308", "1.79e308", "2.3e-308", "10e307", "230e-310", "0"}) {
    INFO(inside);
    CHECK(codes_of_potential(inside).empty());
  }
  for (const char* const outside :
       {"1.8e308", "10e308", "1e309", "1e320", "1e500", "2.2e-308", "1e-308", "1e-320", "1e-500"}) {
    INFO(outside);
    CHECK(codes_of_potential(outside) == "E054");
    CHECK(Built(with("parameters: {k: " + std::string(outside) + "}\n")).codes() == "E054");
  }
}

TEST_CASE("one faulty constant is one finding") { CHECK(codes_of_potential("sqrt(log(0) + 1/0)") == "E053"); }

TEST_CASE("variables are given the benefit of the doubt") {
  CHECK(codes_of_potential("1/x").empty());
  CHECK(codes_of_potential("log(x - x)").empty());
}
