#include "sim/interpreter/expression_compiler.hpp"

#include <charconv>
#include <stdexcept>
#include <string_view>
#include <unordered_map>

namespace gausssim {

namespace {

using Kind = gaussgen::emit::cpp::Expression::Kind;

}  // namespace

double number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument("'" + text + "' is no number");
  return value;
}

Slot ExpressionCompiler::compiled(const Expression& e, Wanted to) {
  switch (e.kind) {
    case Kind::atom: return atom(e.text, to);
    case Kind::negation: return negation(e.operands[0], to);
    case Kind::sum: return sum(e.operands, to);
    case Kind::product: return product(e.operands, Op::multiply, to);
    case Kind::quotient: return quotient(e.operands, to);
    case Kind::call: return call(e.text, e.operands, to);
    case Kind::list: break;
  }
  throw std::invalid_argument("a list where a value is expected");
}

Slot ExpressionCompiler::known(Slot constant, Wanted to) {
  if (!to) return constant;
  writer_.move(*to, constant);
  return *to;
}

Slot ExpressionCompiler::atom(const std::string& text, Wanted to) {
  if (const Slot* const slot = scope_.scalar(text)) return known(*slot, to);
  if (text == "Bool(false)") return known(writer_.number(0), to);
  if (text == "Bool(true)") return known(writer_.number(1), to);
  if (text == "Math<S>::epsilon()") return known(writer_.constant({0, Constant::Kind::epsilon}), to);
  if (text == "Math<S>::pi()") return known(writer_.constant({0, Constant::Kind::pi}), to);
  const Reference place = scope_[text];
  if (!place.is_scalar()) throw std::invalid_argument("'" + text + "' is not one number");
  if (!place.is_argument) return known(place.place, to);
  const Slot slot = target(to);
  writer_.load(slot, place.place, place.offset);
  return slot;
}

Slot ExpressionCompiler::operation(Op op, Wanted to, Slot a, Slot b) {
  const Slot result = target(to);
  writer_.write({op, 1, result, a, b});
  return result;
}

Slot ExpressionCompiler::negation(const Expression& operand, Wanted to) {
  if (operand.kind == Kind::product) return product(operand.operands, Op::negative_product, to);
  const Slot size = value(operand);
  if (const Constant* const constant = writer_.constant_at(size)) {
    Constant opposite = *constant;
    opposite.is_negative = !opposite.is_negative;
    return known(writer_.constant(opposite), to);
  }
  return operation(Op::negate, to, size);
}

// The first term may be in a sum of its own already, to which products are added; else it is a name, and stays what it is.
Slot ExpressionCompiler::sum(const Operands& terms, Wanted to) {
  const Slot result = target(to);
  const bool is_name = terms[0].kind == Kind::atom;
  const Slot first = is_name ? value(terms[0]) : compiled(terms[0], result);
  std::size_t next = 1;
  if (is_name) {
    const bool is_subtracted = terms[1].kind == Kind::negation;
    const Slot second = value(is_subtracted ? terms[1].operands[0] : terms[1]);
    writer_.write({is_subtracted ? Op::subtract : Op::add, 1, result, first, second});
    ++next;
  }
  for (; next < terms.size(); ++next) add(terms[next], result);
  return result;
}

void ExpressionCompiler::add(const Expression& term, Slot sum) {
  const bool is_subtracted = term.kind == Kind::negation;
  const Expression& size = is_subtracted ? term.operands[0] : term;
  if (size.kind == Kind::product) {
    (void)product(size.operands, is_subtracted ? Op::subtract_product : Op::add_product, sum);
  } else {
    writer_.write({is_subtracted ? Op::subtract : Op::add, 1, sum, sum, value(size)});
  }
}

Slot ExpressionCompiler::product(const Operands& factors, Op last, Wanted to) {
  Slot before = value(factors[0]);
  for (std::size_t i = 1; i + 1 < factors.size(); ++i)
    before = operation(Op::multiply, std::nullopt, before, value(factors[i]));
  const Slot factor = value(factors.back());
  return operation(last, to, before, factor);
}

// Compilers divide two literals, rounded as at run time.
Slot ExpressionCompiler::quotient(const Operands& both, Wanted to) {
  const Slot top = value(both[0]), bottom = value(both[1]);
  const Constant* const a = writer_.constant_at(top);
  const Constant* const b = writer_.constant_at(bottom);
  const bool is_known = a != nullptr && b != nullptr && a->kind == Constant::Kind::number &&
                        b->kind == Constant::Kind::number && !b->is_negative;
  if (is_known) return known(writer_.constant({0, Constant::Kind::quotient, a->is_negative, a->a, b->a}), to);
  return operation(Op::divide, to, top, bottom);
}

Slot ExpressionCompiler::literal(const Operands& operands) {
  if (operands.size() != 1 || operands[0].kind != Kind::atom) throw std::invalid_argument("S(…) of no literal");
  const std::string& text = operands[0].text;
  return writer_.number(writer_.integers.has(text) ? writer_.integers(text) : number_in(text));
}

Slot ExpressionCompiler::pieces(const Operands& operands) {
  if (operands.size() != 3) throw std::invalid_argument("Math<S>::constant of other than three numbers");
  return writer_.constant({0, Constant::Kind::pieces, false, number_in(operands[0].text), number_in(operands[1].text),
                           number_in(operands[2].text)});
}

Slot ExpressionCompiler::call(const std::string& callee, const Operands& operands, Wanted to) {
  static const std::string k_math = "Math<S>::";
  if (callee.compare(0, k_math.size(), k_math) == 0)
    return function_of_math(callee.substr(k_math.size()), operands, to);
  if (callee == "S") return known(literal(operands), to);
  if (callee == "StatusOf<S>" && operands.empty()) return known(writer_.number(0), to);
  if (callee == "solve_each") return solve_each(operands, to);
  // It asks whether there is a lane that is lost, and there is one lane: 0 is ok. What it has to say is that of the general way then.
  if (callee == "detail::is_lost<S>" && operands.size() == 1) return compiled(operands[0], to);
  if (callee == "detail::status_of_lost<S>" && operands.size() == 2) return compiled(operands[1], to);
  const std::size_t dot = callee.find('.');
  if (dot != std::string::npos && callee.substr(dot) == ".take")
    return step_of_newton(callee.substr(0, dot), operands, to);
  if (dot != std::string::npos && callee.substr(dot) == ".goes_on" && operands.empty())
    return atom(callee.substr(0, dot), to);
  // A table is called with its type.
  const std::string type = "<S>";
  const bool is_typed =
      callee.size() > type.size() && callee.compare(callee.size() - type.size(), type.size(), type) == 0;
  const int function = writer_.function(is_typed ? callee.substr(0, callee.size() - type.size()) : callee);
  if (function >= 0) return call_of_header(function, operands, to);
  throw std::invalid_argument("a call of '" + callee + "'");
}

void ExpressionCompiler::evaluate(const Expression& call) {
  if (call.kind != Kind::call) throw std::invalid_argument("a statement without effect");
  if (call.text == "Math<S>::sincos" || call.text == "Angles<S>::sincos") return sincos(call.operands);
  if (call.text == "solve") return solve(call.operands);
  if (call.text == "detail::take_lost<S>") return take_lost(call.operands);
  (void)value(call);
}

}  // namespace gausssim
