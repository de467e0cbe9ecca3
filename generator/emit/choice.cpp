#include "emit/choice.hpp"

#include "emit/literal.hpp"

namespace gaussgen::emit {

using cpp::Expression;

namespace {

Expression less(const Expression& a, const Expression& b) { return cpp::call("Math<S>::less", {a, b}); }
Expression at_most(const Expression& a, const Expression& b) { return cpp::call("Math<S>::at_most", {a, b}); }
Expression select(Expression condition, Expression yes, Expression no) {
  return cpp::call("Math<S>::select", {std::move(condition), std::move(yes), std::move(no)});
}

Expression compared(const Comparison& c) {
  return c.is_strict ? less(c.a.value, c.b.value) : at_most(c.a.value, c.b.value);
}

/// b <= a for a < b.
Comparison opposite(const Comparison& c) { return {!c.is_strict, c.b, c.a}; }

/// Not a number if one of them is not: for the case in which neither a < b nor b <= a.
Expression neither(const Comparison& c) {
  if (c.a.is_number) return c.b.value;
  return c.b.is_number ? c.a.value : cpp::sum({c.a.value, c.b.value});
}

}  // namespace

Expression size_of(const Expression& x) { return select(less(x, literal(0)), cpp::negated(x), x); }

// 0 and NaN are their own signs.
Expression sign_of(const Expression& x) {
  return select(less(x, literal(0)), literal(-1), select(less(literal(0), x), literal(1), x));
}

Expression by_case(const Comparison& condition, Expression yes, Expression no) {
  Expression rest = select(compared(opposite(condition)), std::move(no), neither(condition));
  return select(compared(condition), std::move(yes), std::move(rest));
}

// The one that may be no number comes last.
Expression smaller(const Comparand& a, const Comparand& b) {
  if (b.is_number) return select(less(b.value, a.value), b.value, a.value);
  if (a.is_number) return select(at_most(a.value, b.value), a.value, b.value);
  return by_case({false, a, b}, a.value, b.value);
}

Expression larger(const Comparand& a, const Comparand& b) {
  if (b.is_number) return select(less(a.value, b.value), b.value, a.value);
  if (a.is_number) return select(at_most(b.value, a.value), a.value, b.value);
  return by_case({false, b, a}, a.value, b.value);
}

}  // namespace gaussgen::emit
