// Choices as they are emitted, and as a reader of comments sees them.

#include "catch_shim.hpp"
#include "emit/choice.hpp"
#include "emit/cpp_printer.hpp"
#include "emit/formula.hpp"
#include "emit/literal.hpp"

using namespace gaussgen::emit;
using cpp::atom;
using cpp::print;

namespace {

const Comparand a{atom("a"), false};
const Comparand b{atom("b"), false};

std::string formula(const cpp::Expression& e) { return print(as_formula(e)); }

}  // namespace

TEST_CASE("a size and a sign keep what is not a number") {
  CHECK(print(size_of(a.value)) == "Math<S>::select(Math<S>::less(a, S(0)), -a, a)");
  CHECK(print(sign_of(a.value)) ==
        "Math<S>::select(Math<S>::less(a, S(0)), -S(1), Math<S>::select(Math<S>::less(S(0), a), S(1), a))");
}

TEST_CASE("two cases have a third one for what is not a number, unless nothing of the kind can come") {
  const Comparand three{literal(3), true};
  CHECK(print(by_case({true, a, b}, atom("u"), atom("v"))) ==
        "Math<S>::select(Math<S>::less(a, b), u, Math<S>::select(Math<S>::at_most(b, a), v, a + b))");
  CHECK(print(by_case({false, three, a}, atom("u"), atom("v"))) ==
        "Math<S>::select(Math<S>::at_most(S(3), a), u, Math<S>::select(Math<S>::less(a, S(3)), v, a))");
  CHECK(print(smaller(a, three)) == "Math<S>::select(Math<S>::less(S(3), a), S(3), a)");
  CHECK(print(smaller(three, a)) == "Math<S>::select(Math<S>::at_most(S(3), a), S(3), a)");
  CHECK(print(larger(a, three)) == "Math<S>::select(Math<S>::less(a, S(3)), S(3), a)");
  CHECK(print(larger(three, a)) == "Math<S>::select(Math<S>::at_most(a, S(3)), S(3), a)");
}

TEST_CASE("a reader sees the function and not its third case") {
  const Comparand three{literal(3), true};
  CHECK(formula(smaller(a, b)) == "min(a, b)");
  CHECK(formula(larger(a, b)) == "max(a, b)");
  CHECK(formula(size_of(a.value)) == "abs(a)");
  CHECK(formula(by_case({true, a, three}, cpp::product({a.value, a.value}), b.value)) == "piecewise(a < 3, a^2, b)");
  CHECK(formula(by_case({false, a, b}, literal(1), by_case({true, b, three}, literal(2), literal(0)))) ==
        "piecewise(a <= b, 1, piecewise(b < 3, 2, 0))");
}
