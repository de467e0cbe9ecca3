// Calls of Math<S> as instructions.

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <unordered_map>

#include "sim/interpreter/expression_compiler.hpp"

namespace gausssim {

namespace {

const std::unordered_map<std::string, Op>& functions_of_one() {
  static const std::unordered_map<std::string, Op> k_functions{
      {"sin", Op::sin},   {"cos", Op::cos},   {"tan", Op::tan},   {"asin", Op::asin},
      {"acos", Op::acos}, {"atan", Op::atan}, {"exp", Op::exp},   {"log", Op::log},
      {"sinh", Op::sinh}, {"cosh", Op::cosh}, {"tanh", Op::tanh}, {"sqrt", Op::sqrt}};
  return k_functions;
}

const std::unordered_map<std::string, Op>& functions_of_two() {
  static const std::unordered_map<std::string, Op> k_functions{
      {"atan2", Op::atan2}, {"pow", Op::pow}, {"less", Op::less}, {"at_most", Op::at_most}, {"worse", Op::worse}};
  return k_functions;
}

}  // namespace

Slot ExpressionCompiler::function_of_math(const std::string& name, const Operands& operands, Wanted to) {
  if (const auto one = functions_of_one().find(name); one != functions_of_one().end() && operands.size() == 1)
    return operation(one->second, to, value(operands[0]));
  if (const auto two = functions_of_two().find(name); two != functions_of_two().end() && operands.size() == 2) {
    const Slot first = value(operands[0]), second = value(operands[1]);
    return operation(two->second, to, first, second);
  }
  if (name == "constant") return known(pieces(operands), to);
  if (name == "select" && operands.size() == 3) return select(operands, to);
  if (name == "any" && !operands.empty()) return any(operands, to);
  if (name == "not_finite" && !operands.empty()) return not_finite(operands, to);
  if (name == "status" && (operands.size() == 3 || operands.size() == 4)) return status(operands, to);
  throw std::invalid_argument("Math<S>::" + name + " of " + std::to_string(operands.size()) + " arguments");
}

Slot ExpressionCompiler::select(const Operands& operands, Wanted to) {
  const Slot yes = value(operands[1]), no = value(operands[2]);
  const Slot result = target(to);
  put(operands[0], result);
  writer_.write({Op::select, 1, result, yes, no});
  return result;
}

Slot ExpressionCompiler::any(const Operands& operands, Wanted to) {
  const Slot result = target(to);
  Slot so_far = value(operands[0]);
  for (std::size_t i = 1; i < operands.size(); ++i) so_far = operation(Op::either, result, so_far, value(operands[i]));
  return known(so_far, result);
}

// ScalarLogic::not_finite: x - x is 0 for finite x.
Slot ExpressionCompiler::not_finite(const Operands& operands, Wanted to) {
  const Slot first = value(operands[0]);
  const Slot sum = operation(Op::subtract, std::nullopt, first, first);
  for (std::size_t i = 1; i < operands.size(); ++i) writer_.write({Op::add_difference, 1, sum, value(operands[i]), 0});
  return operation(Op::is_no_number, to, sum);
}

Slot ExpressionCompiler::status(const Operands& operands, Wanted to) {
  std::vector<std::uint32_t> conditions;
  std::transform(operands.begin(), operands.end(), std::back_inserter(conditions),
                 [this](const Expression& operand) { return value(operand); });
  const std::size_t all = 4;
  conditions.resize(all, writer_.number(0));
  const Slot result = target(to);
  writer_.write({Op::status, 1, result, writer_.list(conditions), 0});
  return result;
}

// Angles<S>::sincos takes the angles one after the other, as Math<S>::sincos does; none depends on what the others give.
void ExpressionCompiler::sincos(const Operands& operands) {
  if (operands.empty() || operands.size() % 3 != 0) throw std::invalid_argument("sincos without its results");
  for (std::size_t i = 0; i < operands.size(); i += 3) {
    const Slot angle = value(operands[i]);
    writer_.write({Op::sincos, 1, value(operands[i + 1]), angle, value(operands[i + 2])});
  }
}

}  // namespace gausssim
