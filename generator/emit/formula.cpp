#include "emit/formula.hpp"

#include <optional>

#include "emit/cpp_printer.hpp"

namespace gaussgen::emit {

using cpp::Expression;

namespace {

constexpr std::string_view k_scope = "Math<S>::";

/// Math<S>::sin, Math<S>::epsilon(), which is a number on paper, and table<S>.
std::string without_scope(std::string text) {
  if (text.compare(0, k_scope.size(), k_scope) != 0) return text.substr(0, text.rfind("<S>"));
  text.erase(0, k_scope.size());
  const std::size_t size = text.size();
  return size > 2 && text.compare(size - 2, 2, "()") == 0 ? text.substr(0, size - 2) : text;
}

Expression power(const Expression& base, std::size_t exponent) {
  if (exponent == 1) return base;
  const std::string text = print(base);
  const bool is_atom = base.kind == Expression::Kind::atom || base.kind == Expression::Kind::call;
  return cpp::atom((is_atom ? text : "(" + text + ")") + "^" + std::to_string(exponent));
}

Expression with_powers(const std::vector<Expression>& factors) {
  std::vector<Expression> result;
  for (std::size_t first = 0; first < factors.size();) {
    std::size_t last = first + 1;
    while (last < factors.size() && print(factors[last]) == print(factors[first])) ++last;
    result.push_back(power(factors[first], last - first));
    first = last;
  }
  return cpp::product(std::move(result));
}

/// select(less(a, b), a, b) is a minimum, select(less(a, 0), -a, a) a size.
Expression selection(Expression select) {
  const Expression& condition = select.operands[0];
  if (condition.text != "less") return select;
  const std::string a = print(condition.operands[0]), b = print(condition.operands[1]);
  const std::string yes = print(select.operands[1]), no = print(select.operands[2]);
  if (yes == a && no == b) return cpp::call("min", condition.operands);
  if (b == "0" && yes == print(cpp::negated(condition.operands[0])) && no == a)
    return cpp::call("abs", {condition.operands[0]});
  return select;
}

bool is_call(const Expression& e, const std::string& function) {
  return e.kind == Expression::Kind::call && e.text == "Math<S>::" + function;
}

/// b <= a for a < b.
bool are_opposite(const Expression& one, const Expression& other) {
  const bool are_comparisons =
      (is_call(one, "less") && is_call(other, "at_most")) || (is_call(one, "at_most") && is_call(other, "less"));
  return are_comparisons && print(one.operands[0]) == print(other.operands[1]) &&
         print(one.operands[1]) == print(other.operands[0]);
}

Expression comparison(const Expression& condition) {
  const std::string sign = is_call(condition, "less") ? " < " : " <= ";
  return cpp::atom(print(as_formula(condition.operands[0])) + sign + print(as_formula(condition.operands[1])));
}

/// What choice.hpp writes with a third case, for what is not a number: two of several cases, minimum or maximum.
std::optional<Expression> two_cases(const Expression& select) {
  const Expression& condition = select.operands[0];
  const Expression& yes = select.operands[1];
  const Expression& rest = select.operands[2];
  if (!is_call(rest, "select") || !are_opposite(condition, rest.operands[0])) return std::nullopt;
  const Expression& no = rest.operands[1];
  const std::vector<Expression> both{as_formula(yes), as_formula(no)};
  const std::string a = print(condition.operands[0]), b = print(condition.operands[1]);
  if (print(yes) == a && print(no) == b) return cpp::call("min", both);
  if (print(yes) == b && print(no) == a) return cpp::call("max", both);
  return cpp::call("piecewise", {comparison(condition), both[0], both[1]});
}

}  // namespace

Expression as_formula(const Expression& expression) {
  if (is_call(expression, "select")) {
    if (const auto cases = two_cases(expression)) return *cases;
  }
  Expression result = expression;
  result.text = without_scope(expression.text);
  for (Expression& operand : result.operands) operand = as_formula(operand);
  if (result.kind == Expression::Kind::product) return with_powers(result.operands);
  if (result.kind != Expression::Kind::call) return result;
  if (result.text == "S") return result.operands[0];
  return result.text == "select" ? selection(result) : result;
}

}  // namespace gaussgen::emit
