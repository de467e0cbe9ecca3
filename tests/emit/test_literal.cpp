#include "catch_shim.hpp"
#include "emit/cpp_printer.hpp"
#include "emit/literal.hpp"

using namespace gaussgen;
using support::Rational;

namespace {

std::string text(const Rational& value) { return emit::cpp::print(emit::literal(value)); }

}  // namespace

TEST_CASE("rationals are exact in every scalar type") {
  CHECK(text(3) == "S(3)");
  CHECK(text(-3) == "-S(3)");
  CHECK(text(Rational(2) / 5) == "S(2) / S(5)");
  CHECK(text(Rational(-2) / 5) == "-S(2) / S(5)");
  CHECK(text(Rational(1) / 2) == "S(0.5)");
  CHECK(text(Rational(981) / 100) == "S(981) / S(100)");
}

TEST_CASE("whole numbers that float would round are exact, and no literal of another type is converted") {
  CHECK(text(Rational("4294967296")) == "S(4294967296.0)");
  CHECK(text(cln::expt_pos(cln::cl_I(2), 53) - 1) == "Math<S>::constant(9007199254740991.0, 0.0, 0.0)");
}

TEST_CASE("what double cannot hold comes in three pieces") {
  CHECK(text(cln::expt_pos(cln::cl_I(10), 30) + 1) == "Math<S>::constant(1e+30, -19884624838655.0, 0.0)");
}

TEST_CASE("comments show decimals where they are finite") {
  CHECK(emit::decimal_text(Rational(981) / 100) == "9.81");
  CHECK(emit::decimal_text(Rational(1) / 3) == "1/3");
}
