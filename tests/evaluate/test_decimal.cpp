#include <cln/real.h>

#include <clocale>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/decimal.hpp"

namespace {

using namespace gaussgen::evaluate;

std::string text(const Rational& value, int digits) {
  return to_decimal(Arithmetic<cln::cl_F>(60).number(value), digits);
}

Rational power_of_ten(int n) { return cln::expt_pos(cln::cl_I(10), cln::cl_I(n)); }

TEST_CASE("numbers are printed with the digits asked for", "[evaluate]") {
  CHECK(text(Rational(1) / 3, 5) == "0.33333");
  CHECK(text(Rational(2) / 3, 5) == "0.66667");
  CHECK(text(Rational(-5) / 4, 3) == "-1.25");
  CHECK(text(1200, 5) == "1200.0");
  CHECK(text(1200, 4) == "1200");
  CHECK(text(7, 1) == "7");
  CHECK(text(0, 10) == "0");
}

TEST_CASE("very large and very small numbers get an exponent", "[evaluate]") {
  CHECK(text(1200, 3) == "1.20e+3");
  CHECK(text(40, 1) == "4e+1");
  CHECK(text(1 / power_of_ten(12), 4) == "1.000e-12");
  CHECK(text(Rational(1) / 2000, 2) == "0.00050");
  CHECK(text(Rational(-1) / 100000, 2) == "-0.000010");
  CHECK(text(Rational(1) / 1000000, 2) == "1.0e-6");
  CHECK(text(power_of_ten(3000), 3) == "1.00e+3000");
}

TEST_CASE("rounding may carry into a new digit", "[evaluate]") {
  CHECK(text(Rational(9999) / 1000, 3) == "10.0");
  CHECK(text(Rational(99999) / 100000, 3) == "1.00");
  CHECK(text(999, 2) == "1.0e+3");
  CHECK(text(Rational(5) / 2, 1) == "2");
  CHECK(text(Rational(7) / 2, 1) == "4");
}

TEST_CASE("a locale with a decimal comma changes nothing", "[evaluate]") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(text(Rational(1) / 8, 3) == "0.125");
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
