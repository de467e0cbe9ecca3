#include "catch_shim.hpp"
#include "emit/identifiers.hpp"
#include "emit/names.hpp"

using namespace gaussgen::emit;

TEST_CASE("valid names stay as they are") {
  for (const char* name : {"chi", "theta_dot", "e0", "R", "J_1", "y0", "gamma", "mass"}) CHECK(mangled(name) == name);
}

TEST_CASE("keywords, alternative tokens, macros and our own names get an underscore") {
  for (const std::string name : {"new", "and", "xor_eq", "co_await", "char8_t", "I", "linux", "unix", "EOF", "NAN", "M_PI", "errno",
                                 "major", "minor", "BYTE_ORDER", "M_PIl", "SEEK_SET",
                                 "issubnormal", "BOOST_VERSION", "rad1", "values", "state", "out", "prepared", "S", "t", "min"}) {
    CHECK(mangled(name) == name + "_");
  }
}

TEST_CASE("names that belong to the compiler are changed") {
  CHECK(mangled("_Reserved") == "Reserved");
  CHECK(mangled("a__b") == "a_b");
  CHECK(mangled("2x") == "v2x");
  CHECK(mangled("x;y") == "x_y");
}

TEST_CASE("no two things share a name") {
  NameScope scope;
  CHECK(scope.allocate("x") == "x");
  CHECK(scope.allocate("x") == "x_2");
  CHECK(scope.allocate("x_2") == "x_2_2");
  CHECK(scope.allocate("new") == "new_");
  CHECK(scope.allocate("new_") == "new_2");
  scope.reserve("t1");
  CHECK(scope.allocate_anonymous("t") == "t2");
}
