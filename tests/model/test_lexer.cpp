#include "building.hpp"
#include "catch_shim.hpp"

using test::parsed;

namespace {

std::string hint(const std::string& text) {
  const test::Parsed result(text);
  return result.diagnostics.all().empty() ? "" : result.diagnostics.all()[0].hint;
}

}  // namespace

TEST_CASE("decimals are exact") {
  CHECK(parsed("0.1") == "1/10");
  CHECK(parsed("9.81") == "981/100");
  CHECK(parsed("1.50e-3") == "3/2000");
  CHECK(parsed("2E3") == "2000");
  CHECK(parsed(".5") == "1/2");
  CHECK(parsed("5.") == "5");
  CHECK(parsed("1e+2") == "100");
}

TEST_CASE("leading zeros do not make a number octal") { CHECK(parsed("010") == "10"); }

TEST_CASE("digits and exponents are bounded") {
  CHECK(parsed(std::string(40, '1')) == std::string(40, '1'));
  CHECK(parsed(std::string(41, '1')) == "E032@0");
  CHECK(parsed("1e308").size() == 309);
  CHECK(parsed("1e401") == "E054@0");
  CHECK(parsed("1e-401") == "E054@0");
  CHECK(parsed("1e99999999999999999999") == "E054@0");
}

TEST_CASE("an e without digits is an exponent that lacks them, unless it begins a name") {
  CHECK(parsed("2e") == "E032@0");
  CHECK(parsed("2e-") == "E032@0");
  CHECK(parsed("2exp(x)") == "E035@1");
  CHECK(parsed("2e_1") == "E035@1");
}

TEST_CASE("malformed numbers are numbers, not products") {
  CHECK(parsed("1.2.3") == "E032@0");
  CHECK(parsed("0x10") == "E032@0");
  CHECK(parsed("0o17") == "E032@0");
  CHECK(parsed("0b1") == "E032@0");
  CHECK(parsed("1_000") == "E032@0");
  CHECK(parsed(".nan") == "E032@0");
}

TEST_CASE("what is not ASCII is named, with what to write instead") {
  CHECK(parsed("cos(\xCE\xB8)") == "E030@4");
  CHECK(hint("cos(\xCE\xB8)").find("theta") != std::string::npos);
  CHECK(hint("x \xE2\x88\x92 1").find("minus") != std::string::npos);
  CHECK(hint("x\xC2\xA0+ 1").find("space") != std::string::npos);
  CHECK(hint("x\xC2\xB2").find("^2") != std::string::npos);
  CHECK(parsed("x \xF0\x9F\x98\x80") == "E030@2");
}

TEST_CASE("two stars are refused with the power sign as the hint") {
  CHECK(parsed("x**2") == "E030@1");
  CHECK(hint("x**2").find("^") != std::string::npos);
}

TEST_CASE("other signs of programming languages are refused") {
  for (const char* text :
       {"x = 1", "x == 1", "x < 1", "x ? 1", "{x}", "[x]", "x; y", "x % 2", "x'", "x!", "\"x\"", "x // y", "@x"}) {
    INFO(text);
    CHECK_FALSE(test::Parsed(text).ast);
  }
}

TEST_CASE("names of C++ are ordinary names") {
  for (const char* name :
       {"class", "int", "and", "new", "std", "gamma", "y0", "errno", "NAN", "nan", "inf", "fabs", "E"})
    CHECK(parsed(name) == name);
}
