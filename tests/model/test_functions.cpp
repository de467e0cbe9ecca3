// abs to piecewise: how they are written, and their exact values.

#include <cmath>

#include "building.hpp"
#include "catch_shim.hpp"
#include "model/constant.hpp"
#include "model/evaluate.hpp"

using test::parsed;

namespace {

std::string exact(const std::string& text) {
  const test::Parsed parsed(text);
  REQUIRE(parsed.ast);
  const auto value = gaussgen::model::exact_value(*parsed.ast);
  return value ? gaussgen::support::to_text(*value) : "none";
}

double value(const std::string& text, double x) {
  const test::Parsed parsed(text);
  REQUIRE(parsed.ast);
  const auto value = gaussgen::model::value_of(*parsed.ast, {{"x", x}});
  REQUIRE(value);
  return *value;
}

const double k_nan = std::nan("");

}  // namespace

TEST_CASE("min and max take two arguments or more, piecewise pairs and a last value") {
  CHECK(parsed("min(a, b)") == "(min a b)");
  CHECK(parsed("max(a, b, c, d)") == "(max a b c d)");
  CHECK(parsed("piecewise(a < b, 1, 2)") == "(piecewise (< a b) 1 2)");
  CHECK(parsed("piecewise(a + 1 >= 2*b, 1, c > d, 2, 3)") == "(piecewise (>= (+ a 1) (* 2 b)) 1 (> c d) 2 3)");
  CHECK(parsed("min(a)") == "E036@0");
  CHECK(parsed("piecewise(a < b, 1)") == "E036@0");
  CHECK(parsed("piecewise(a < b, 1, c < d, 2)") == "E036@0");
}

TEST_CASE("pow with a constant exponent is a power") {
  CHECK(parsed("pow(x + 1, 3)") == "(^ (+ x 1) 3)");
  CHECK(parsed("-pow(x, -1/2)") == "(- (^ x -1/2))");
  CHECK(parsed("pow(x, abs(-2))") == "(^ x 2)");
  CHECK(parsed("pow(x, y)") == "E037@7");
  CHECK(parsed("pow(x)") == "E036@0");
}

TEST_CASE("a comparison stands as a condition of piecewise and nowhere else") {
  CHECK(parsed("a < b") == "E066@2");
  CHECK(parsed("2*(a <= b)") == "E066@5");
  CHECK(parsed("sin(a < b)") == "E066@4");
  CHECK(parsed("piecewise(a, 1, 2)") == "E066@10");
  CHECK(parsed("piecewise(a < b, c < d, 2)") == "E066@17");
  CHECK(parsed("piecewise(a < b < c, 1, 2)") == "E066@16");
  CHECK(parsed("piecewise(a < b and c < d, 1, 2)") == "E066@16");
  CHECK(parsed("piecewise((a < b), 1, 2)") == "E066@13");
  CHECK(parsed("piecewise(a <, 1, 2)") == "E033@13");
  CHECK(parsed("piecewise(a == b, 1, 2)") == "E030@12");
}

TEST_CASE("of numbers, what is chosen is exact") {
  CHECK(exact("abs(-1/3)") == "1/3");
  CHECK(exact("sign(0.1 - 0.3) + sign(0) + 5*sign(7)") == "4");
  CHECK(exact("min(1, 1/3, 2)") == "1/3");
  CHECK(exact("max(-1, -1/3)") == "-1/3");
  CHECK(exact("piecewise(1 < 1, 10, 1 <= 1, 20, 30)") == "20");
  CHECK(exact("piecewise(1 > 1, 10, 30)") == "30");
  CHECK(exact("piecewise(1 >= 1, 10, 30)") == "10");
  CHECK(exact("abs(x)") == "none");
}

TEST_CASE("in double, a case that is not chosen does not count, and no NaN gets lost") {
  CHECK(value("piecewise(x > 0, log(x), -1)", -2) == -1);
  CHECK(value("piecewise(x > 0, log(x), -1)", 1) == 0);
  CHECK(value("abs(x) + sign(x)", -2) == 1);
  CHECK(value("min(x, 3, 2*x) - max(1, x)", 2) == 0);
  for (const char* text : {"abs(x)", "sign(x)", "min(x, 1)", "min(1, x)", "max(x, 1)", "max(1, x)",
                           "piecewise(x < 1, 2, 3)", "piecewise(1 < x, 2, 3)", "piecewise(0 > 1, 2, x < 1, 2, 3)"}) {
    INFO(text);
    CHECK(std::isnan(value(text, k_nan)));
  }
}

TEST_CASE("an exact value is not mistaken for rounding") {
  CHECK(
      test::Built(test::with("parameters: {a: 1/abs(-1e-20)}\nforces: {f: {generalized: {x: a}}}\n")).codes().empty());
  CHECK(test::Built(test::with("parameters: {a: 1/(abs(-2) - 2)}\nforces: {f: {generalized: {x: a}}}\n")).codes() ==
        "E053");
}
