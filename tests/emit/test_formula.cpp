#include "catch_shim.hpp"
#include "emit/cpp_printer.hpp"
#include "emit/formula.hpp"

using gaussgen::emit::as_formula;
using namespace gaussgen::emit::cpp;

namespace {

const Expression a = atom("a");
const Expression b = atom("b");

Expression number(const std::string& text) { return call("S", {atom(text)}); }
Expression select_less(const Expression& left, const Expression& right, const Expression& yes, const Expression& no) {
  return call("Math<S>::select", {call("Math<S>::less", {left, right}), yes, no});
}
std::string text(const Expression& expression) { return print(as_formula(expression)); }

}  // namespace

TEST_CASE("a formula in a comment is as on paper: no types, powers, minimum and size") {
  CHECK(text(quotient(number("1"), product({number("2"), a}))) == "1 / (2 * a)");
  CHECK(text(product({a, a, a, b, a})) == "a^3 * b * a");
  CHECK(text(product({sum({a, negated(b)}), sum({a, negated(b)})})) == "(a - b)^2");
  CHECK(text(product({call("Math<S>::sin", {a}), call("Math<S>::sin", {a})})) == "sin(a)^2");
  CHECK(text(product({number("20"), atom("Math<S>::epsilon()"), a})) == "20 * epsilon * a");
  CHECK(text(select_less(a, b, a, b)) == "min(a, b)");
  CHECK(text(select_less(a, number("0"), negated(a), a)) == "abs(a)");
  CHECK(text(select_less(a, b, b, a)) == "select(less(a, b), b, a)");
}
