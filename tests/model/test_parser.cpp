#include "building.hpp"
#include "catch_shim.hpp"

using test::parsed;

TEST_CASE("sums and products are flat, with wrapped inverse terms") {
  CHECK(parsed("a + b - c") == "(+ a b (- c))");
  CHECK(parsed("a*b/c*d") == "(* a b (/ c) d)");
  CHECK(parsed("2/5*m*r^2") == "(* 2 (/ 5) m (^ r 2))");
  CHECK(parsed("a - (b - c)") == "(+ a (- (+ b (- c))))");
}

TEST_CASE("unary minus binds as in mathematics") {
  CHECK(parsed("-x^2") == "(- (^ x 2))");
  CHECK(parsed("(-x)^2") == "(^ (- x) 2)");
  CHECK(parsed("-x*y") == "(* (- x) y)");
  CHECK(parsed("2*-x") == "(* 2 (- x))");
  CHECK(parsed("a - -b") == "(+ a (- (- b)))");
  CHECK(parsed("+x") == "x");
}

TEST_CASE("powers are right associative and exponents are folded") {
  CHECK(parsed("x^2^3") == "(^ x 8)");
  CHECK(parsed("x^-2") == "(^ x -2)");
  CHECK(parsed("x^(1/2)") == "(^ x 1/2)");
  CHECK(parsed("x^-2^2") == "(^ x -4)");
  CHECK(parsed("x^(3 - 1)") == "(^ x 2)");
  CHECK(parsed("x^1/2") == "(* (^ x 1) (/ 2))");
}

TEST_CASE("functions take their number of arguments") {
  CHECK(parsed("sin(x)") == "(sin x)");
  CHECK(parsed("atan2(y, x + 1)") == "(atan2 y (+ x 1))");
  CHECK(parsed("dot(rho*cos(chi))") == "(dot (* rho (cos chi)))");
  CHECK(parsed("atan2(y)") == "E036@0");
  CHECK(parsed("sin(x, y)") == "E036@0");
  CHECK(parsed("sin()") == "E036@0");
}

TEST_CASE("blanks and line breaks separate and mean nothing") { CHECK(parsed(" a\t+\n b ") == "(+ a b)"); }

TEST_CASE("mistakes that leave the syntax alone do not hide what follows") {
  CHECK(parsed("foo(x) + bar(y)") == "2 errors");
  CHECK(parsed("sin(x, y) + cos()") == "2 errors");
  CHECK(parsed("x^y + x^10001 + a b") == "3 errors");
  CHECK(parsed("foo(x) + 2..5") == "2 errors");
}

TEST_CASE("one mistake is one message") {
  CHECK(parsed("x^y^y") == "E037@4");
  CHECK(parsed("x^foo(y)") == "E036@2");
  CHECK(parsed("sin(x + (y z") == "E035@11");
  CHECK(parsed("sin(x, $") == "E030@7");
  CHECK(parsed("sin(x + y$") == "E030@9");
}

TEST_CASE("a product needs its operator") {
  CHECK(parsed("2x") == "E035@1");
  CHECK(parsed("x y") == "E035@2");
  CHECK(parsed("(a)(b)") == "E035@3");
  CHECK(parsed("(a) b") == "E035@4");
  CHECK(parsed("sin(x) 2") == "E035@7");
}

TEST_CASE("a bracket that is open or closes nothing is reported at the bracket") {
  CHECK(parsed("2*(a + b") == "E034@2");
  CHECK(parsed("sin(a") == "E034@3");
  CHECK(parsed("a + b)") == "E034@5");
}

TEST_CASE("a missing operand is reported where it is missing") {
  CHECK(parsed("a +") == "E033@3");
  CHECK(parsed("a * / b") == "E033@4");
  CHECK(parsed("()") == "E033@1");
  CHECK(parsed("*a") == "E033@0");
  CHECK(parsed("sin(,)") == "E033@4");
}

TEST_CASE("an empty text is a missing expression") {
  CHECK(parsed("").substr(0, 4) == "E039");
  CHECK(parsed("  ").substr(0, 4) == "E039");
}

TEST_CASE("an exponent is a small constant") {
  CHECK(parsed("x^64") == "(^ x 64)");
  CHECK(parsed("x^10000") == "(^ x 10000)");  // as q^$i in so many copies
  CHECK(parsed("x^10001") == "E037@2");
  CHECK(parsed("x^(1/65)") == "E037@2");
  CHECK(parsed("x^y") == "E037@2");
  CHECK(parsed("x^(1/0)") == "E037@2");
  CHECK(parsed("9^9^9^9") == "E037@4");
}

TEST_CASE("a span covers the part with its brackets") {
  const test::Parsed text("a*(b + c)");
  REQUIRE(text.ast);
  CHECK(text.ast->span.begin == 0);
  CHECK(text.ast->span.end == 9);
  CHECK(text.ast->children[1].span.begin == 2);
  CHECK(text.ast->children[1].span.end == 9);
}

TEST_CASE("depth is bounded for brackets, signs, powers and calls alike") {
  const auto repeated = [](const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
  };
  CHECK(parsed(std::string(64, '(') + "x" + std::string(64, ')')) == "x");
  CHECK(parsed(std::string(65, '(') + "x" + std::string(65, ')')).substr(0, 4) == "E038");
  CHECK(parsed(std::string(60'000, '(')).substr(0, 4) == "E038");
  CHECK(parsed(std::string(10'000, '-') + "x").substr(0, 4) == "E038");
  CHECK(parsed(std::string(10'000, '+') + "x").substr(0, 4) == "E038");
  CHECK(parsed(repeated("sin(", 5'000)).substr(0, 4) == "E038");
  CHECK(parsed("1" + repeated("^1", 5'000)).substr(0, 4) == "E038");
}

TEST_CASE("a long flat sum is fine and is one node") {
  std::string text = "x";
  for (int i = 0; i < 9'000; ++i) text += "+x";
  const test::Parsed sum(text);
  REQUIRE(sum.ast);
  CHECK(sum.ast->children.size() == 9'001);
}

TEST_CASE("length and number of parts are bounded") {
  CHECK(parsed(std::string(70'000, ' ') + "x").substr(0, 4) == "E038");
  std::string text = "x";
  for (int i = 0; i < 10'000; ++i) text += "+x";
  CHECK(parsed(text).substr(0, 4) == "E038");
}

TEST_CASE("powers that would explode are refused before anything is computed") {
  CHECK(parsed("((9^64)^64)^64").substr(0, 4) == "E038");
  CHECK(parsed("((((((x^64)^64)^64)^64)^64)^64)").substr(0, 4) == "E038");
  CHECK(parsed("x^((((9^64)^64)^64)^64)").substr(0, 4) == "E037");
}
