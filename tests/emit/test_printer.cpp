#include <sstream>

#include "catch_shim.hpp"
#include "emit/cpp_printer.hpp"
#include "emit/line.hpp"

using namespace gaussgen::emit::cpp;

namespace {

const Expression a = atom("a");
const Expression b = atom("b");
const Expression c = atom("c");

}  // namespace

TEST_CASE("brackets stand where precedence needs them, and only there") {
  CHECK(print(product({a, sum({b, c})})) == "a * (b + c)");
  CHECK(print(sum({a, product({b, c})})) == "a + b * c");
  CHECK(print(sum({a, negated(sum({b, c}))})) == "a - (b + c)");
  CHECK(print(sum({a, negated(product({b, c}))})) == "a - b * c");
  CHECK(print(quotient(product({a, b}), product({b, c}))) == "a * b / (b * c)");
  CHECK(print(quotient(a, quotient(b, c))) == "a / (b / c)");
  CHECK(print(product({quotient(a, b), c})) == "a / b * c");
  CHECK(print(product({a, quotient(b, c)})) == "a * (b / c)");
  CHECK(print(negated(sum({a, b}))) == "-(a + b)");
  CHECK(print(negated(negated(a))) == "a");
  CHECK(print(call("f", {sum({a, b}), negated(c)})) == "f(a + b, -c)");
}

TEST_CASE("two signs never meet: those of factors go in front, where they cancel or subtract") {
  const Expression twice = product({call("S", {atom("2")}), a});
  CHECK(print(product({a, negated(b)})) == "-a * b");
  CHECK(print(product({negated(twice), b})) == "-S(2) * a * b");
  CHECK(print(negated(product({negated(twice), b}))) == "S(2) * a * b");
  CHECK(print(negated(product({a, negated(b), c}))) == "a * b * c");
  CHECK(print(negated(quotient(negated(a), b))) == "a / b");
  CHECK(print(negated(quotient(a, negated(b)))) == "a / b");
  CHECK(print(quotient(product({negated(a), b}), negated(c))) == "a * b / c");
  CHECK(print(sum({c, product({negated(a), b})})) == "c - a * b");
  CHECK(print(sum({c, negated(product({negated(a), b}))})) == "c + a * b");
  CHECK(print(sum({c, quotient(negated(a), b)})) == "c - a / b");
}

TEST_CASE("long statements are broken before an operator, outermost first") {
  std::vector<Expression> terms;
  for (int i = 0; i < 30; ++i) terms.push_back(product({atom("coefficient_" + std::to_string(i)), sum({a, b})}));
  std::istringstream lines(Line(2).text("x = ").expression(sum(terms)).text(";").str());
  std::string line;
  int count = 0;
  while (std::getline(lines, line)) {
    CHECK(line.size() <= k_line_length);
    CHECK(line.back() != ' ');
    if (count++ > 0) CHECK(line.substr(0, 8) == "      + ");
  }
  CHECK(count > 5);
}
