// CLN arithmetic against digits from the literature (Abramowitz and Stegun, OEIS) and against identities.

#include <cln/real.h>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/decimal.hpp"

namespace {

using namespace gaussgen::evaluate;
using cln::cl_F;
using gaussgen::ir::Function;

struct Fixture {
  Arithmetic<cl_F> arithmetic{50};

  cl_F number(const Rational& value) const { return arithmetic.number(value); }
  std::string call(Function function, const Rational& x) const { return text(arithmetic.call(function, {number(x)})); }
  static std::string text(const Outcome<cl_F>& outcome) {
    return outcome ? to_decimal(*outcome, 50) : std::string(outcome.reason());
  }
};

const Rational k_half = Rational(1) / 2;

Rational power_of_ten(int n) { return cln::expt_pos(cln::cl_I(10), cln::cl_I(n)); }

TEST_CASE_METHOD(Fixture, "fifty digits of the elementary functions are right", "[evaluate]") {
  CHECK(call(Function::sin, 1) == "0.84147098480789650665250232163029899962256306079837");
  CHECK(call(Function::cos, 1) == "0.54030230586813971740093660744297660373231042061792");
  CHECK(call(Function::tan, 1) == "1.5574077246549022305069748074583601730872507723815");
  CHECK(call(Function::exp, 1) == "2.7182818284590452353602874713526624977572470937000");
  CHECK(call(Function::log, 2) == "0.69314718055994530941723212145817656807550013436026");
  CHECK(call(Function::sinh, 1) == "1.1752011936438014568823818505956008151557179813341");
  CHECK(call(Function::cosh, 1) == "1.5430806348152437784779056207570616826015291123659");
  CHECK(call(Function::tanh, 1) == "0.76159415595576488811945828260479359041276859725794");
  CHECK(call(Function::atan, 1) == "0.78539816339744830961566084581987572104929234984378");
  CHECK(call(Function::asin, k_half) == "0.52359877559829887307710723054658381403286156656252");
  CHECK(call(Function::acos, k_half) == "1.0471975511965977461542144610931676280657231331250");
  CHECK(to_decimal(arithmetic.pi(), 50) == "3.1415926535897932384626433832795028841971693993751");
}

TEST_CASE_METHOD(Fixture, "fifty digits of roots and powers are right", "[evaluate]") {
  CHECK(text(arithmetic.power(number(2), k_half)) == "1.4142135623730950488016887242096980785696718753769");
  CHECK(text(arithmetic.power(number(2), Rational(1) / 3)) == "1.2599210498948731647672106072782283505702514647015");
  CHECK(text(arithmetic.power(number(2), -k_half)) == "0.70710678118654752440084436210484903928483593768847");
  CHECK(text(arithmetic.power(number(3), -2)) == "0.11111111111111111111111111111111111111111111111111");
  CHECK(text(arithmetic.power(number(-2), 3)) == "-8.0000000000000000000000000000000000000000000000000");
  CHECK(text(arithmetic.power(number(0), k_half)) == "0");
}

TEST_CASE_METHOD(Fixture, "the angle of a vector is right in every quadrant", "[evaluate]") {
  const auto angle = [this](int y, int x) { return text(arithmetic.call(Function::atan2, {number(y), number(x)})); };
  CHECK(angle(1, 1) == "0.78539816339744830961566084581987572104929234984378");
  CHECK(angle(1, -1) == "2.3561944901923449288469825374596271631478770495313");
  CHECK(angle(-1, -1) == "-2.3561944901923449288469825374596271631478770495313");
  CHECK(angle(-1, 1) == "-0.78539816339744830961566084581987572104929234984378");
  CHECK(angle(0, 1) == "0");
  CHECK(angle(0, -1) == "3.1415926535897932384626433832795028841971693993751");
  CHECK(angle(1, 0) == "1.5707963267948966192313216916397514420985846996876");
}

TEST_CASE_METHOD(Fixture, "large arguments lose no digits", "[evaluate]") {
  // sin(10^22): the classic of argument reduction (Ng 1992).
  CHECK(to_decimal(*arithmetic.call(Function::sin, {number(power_of_ten(22))}), 16) == "-0.8522008497671888");
  // Twice as many digits confirm the rest.
  const Arithmetic<cl_F> fine(150);
  for (const Function function : {Function::sin, Function::cos, Function::tan}) {
    const auto coarse_value = arithmetic.call(function, {number(power_of_ten(40) + 1)});
    const auto fine_value = fine.call(function, {fine.number(power_of_ten(40) + 1)});
    CHECK(to_decimal(*coarse_value, 50) == to_decimal(*fine_value, 50));
  }
  const auto coarse_value = arithmetic.call(Function::exp, {number(Rational(50001) / 7)});
  const auto fine_value = fine.call(Function::exp, {arithmetic.number(Rational(50001) / 7)});
  CHECK(to_decimal(*coarse_value, 50) == to_decimal(*fine_value, 50));
}

TEST_CASE_METHOD(Fixture, "a sine near a multiple of pi keeps its digits", "[evaluate]") {
  const cl_F near = number(Rational(355));
  CHECK(to_decimal(*arithmetic.call(Function::sin, {near}), 16) == "-0.00003014435335948845");
  const cl_F nearest = arithmetic.number(arithmetic.pi() * number(1000));
  const Arithmetic<cl_F> fine(300);
  CHECK(text(arithmetic.call(Function::sin, {nearest})) ==
        to_decimal(*fine.call(Function::sin, {fine.number(nearest)}), 50));
}

TEST_CASE_METHOD(Fixture, "small arguments keep their digits", "[evaluate]") {
  const Rational tiny = 1 / power_of_ten(30);
  CHECK(call(Function::sin, 1 / power_of_ten(20)) == "9.9999999999999999999999999999999999999998333333333e-21");
  CHECK(call(Function::sin, tiny) == "1.0000000000000000000000000000000000000000000000000e-30");
  CHECK(to_decimal(*arithmetic.call(Function::tanh, {number(tiny)}), 20) == "1.0000000000000000000e-30");
  CHECK(to_decimal(*arithmetic.call(Function::asin, {number(tiny)}), 20) == "1.0000000000000000000e-30");
  CHECK(to_decimal(*arithmetic.call(Function::log, {number(1 + tiny)}), 20) == "1.0000000000000000000e-30");
}

TEST_CASE_METHOD(Fixture, "no argument makes CLN throw", "[evaluate]") {
  const Rational huge = power_of_ten(15000);
  CHECK(call(Function::exp, huge) == reason::k_overflow);
  CHECK(call(Function::exp, -huge) == "0");
  CHECK(call(Function::sinh, -huge) == reason::k_overflow);
  CHECK(call(Function::cosh, huge) == reason::k_overflow);
  CHECK(to_decimal(*arithmetic.call(Function::tanh, {number(huge)}), 3) == "1.00");
  CHECK(to_decimal(*arithmetic.call(Function::tanh, {number(-huge)}), 3) == "-1.00");
  CHECK(call(Function::log, 0) == reason::k_logarithm);
  CHECK(call(Function::log, -1) == reason::k_logarithm);
  CHECK(call(Function::asin, 2) == reason::k_arc);
  CHECK(call(Function::acos, Rational(-3) / 2) == reason::k_arc);
  CHECK(text(arithmetic.call(Function::atan2, {number(0), number(0)})) == reason::k_direction);
  CHECK(text(arithmetic.power(number(0), -1)) == reason::k_division);
  CHECK(text(arithmetic.power(number(-8), Rational(1) / 3)) == reason::k_root);
  CHECK(text(arithmetic.power(number(huge), 1000)) == reason::k_overflow);
  CHECK(text(arithmetic.power(number(huge), -1000)) == "0");
  CHECK(text(arithmetic.product({number(huge), number(huge)})) == reason::k_overflow);
  CHECK(text(arithmetic.product({number(1 / huge), number(1 / huge)})) == "0");
  CHECK(arithmetic.call(Function::sin, {number(huge)}));
}

TEST_CASE_METHOD(Fixture, "zero is an ordinary number", "[evaluate]") {
  const cl_F zero = number(0);
  CHECK(text(arithmetic.sum(0, {1, -1}, {number(2), number(2)})) == "0");
  CHECK(text(arithmetic.product({zero, number(3)})) == "0");
  for (const Function f :
       {Function::sin, Function::tan, Function::asin, Function::atan, Function::sinh, Function::tanh}) {
    CHECK(call(f, 0) == "0");
  }
  CHECK(to_decimal(*arithmetic.call(Function::cos, {zero}), 2) == "1.0");
  CHECK(to_decimal(*arithmetic.call(Function::acos, {zero}), 5) == "1.5708");
  CHECK(to_decimal(*arithmetic.call(Function::exp, {zero}), 2) == "1.0");
}

TEST_CASE("results keep the precision that was asked for", "[evaluate]") {
  for (const int digits : {1, 15, 50, 200}) {
    const Arithmetic<cl_F> arithmetic(digits);
    const auto bits = cln::float_digits(arithmetic.number(Rational(1)));
    CHECK(static_cast<double>(bits) * 0.30103 >= digits + 10);
    for (int i = 0; i <= static_cast<int>(Function::tanh); ++i) {
      const std::vector<cl_F> x(2, arithmetic.number(Rational(1) / 3));
      const auto value = arithmetic.call(static_cast<Function>(i), x);
      REQUIRE(value);
      CHECK(cln::float_digits(*value) == bits);
    }
    CHECK(cln::float_digits(*arithmetic.power(arithmetic.number(0.5), Rational(1) / 3)) == bits);
    CHECK(cln::float_digits(arithmetic.number(0.1)) == bits);
  }
}

TEST_CASE("the rounding unit is that of the type", "[evaluate]") {
  CHECK(Arithmetic<double>().epsilon() == 0x1p-53);
  CHECK(Arithmetic<cl_F>(50).epsilon() <
        cln::cl_float(1, cln::float_format(60)) * cln::cl_float(1e-59, cln::float_format(60)));
}

TEST_CASE("a double enters without rounding", "[evaluate]") {
  for (const double value : {0.1, -3.0, 1e300, 5e-324, 2.2250738585072014e-308, 0.0, 123456789.125}) {
    CHECK(Arithmetic<double>().number(exact(value)) == value);
  }
  CHECK(gaussgen::support::to_text(exact(0.375)) == "3/8");
  CHECK(gaussgen::support::to_text(exact(-6.0)) == "-6");
  CHECK(Arithmetic<long double>().number(exact(0.1L)) == 0.1L);
  CHECK(Arithmetic<long double>().number(exact(1e4000L)) == 1e4000L);
  CHECK_FALSE(Arithmetic<double>().sum(power_of_ten(400), {}, {}));
  CHECK(Arithmetic<long double>().number(Rational(1) / 3) == 1.0L / 3.0L);
}

}  // namespace
