// Calls of functions of the header and of its prelude as instructions.

#include <algorithm>
#include <stdexcept>

#include "sim/interpreter/expression_compiler.hpp"

namespace gausssim {

namespace {

using Kind = gaussgen::emit::cpp::Expression::Kind;

bool is_one_scalar(const Parameter& parameter) { return parameter.type == "S" || parameter.type == "StatusOf"; }

}  // namespace

Passed ExpressionCompiler::passed(const Parameter& parameter, const Expression& argument) {
  if (argument.kind != Kind::atom || scope_.scalar(argument.text) != nullptr) {
    if (!is_one_scalar(parameter)) throw std::invalid_argument("an argument of type " + parameter.type);
    return {false, value(argument), 0};
  }
  const Reference place = scope_[argument.text];
  const bool fits = is_one_scalar(parameter)  ? place.is_scalar()
                    : place.layout != nullptr ? place.layout->name == parameter.type
                                              : parameter.type == "S[" + std::to_string(place.size()) + "]";
  if (!fits) throw std::invalid_argument("'" + argument.text + "' as an argument of type " + parameter.type);
  return {place.is_argument, place.place, static_cast<std::uint32_t>(place.offset)};
}

// A value that is returned comes last, and stands where it is wanted.
Slot ExpressionCompiler::call_of_header(int function, const Operands& operands, Wanted to) {
  const auto place = static_cast<std::size_t>(function);
  const Function& callee = writer_.program().functions[place];
  const bool gives_scalar = callee.parameters.size() == operands.size() + 1 && is_one_scalar(callee.parameters.back());
  if (!gives_scalar && callee.parameters.size() != operands.size())
    throw std::invalid_argument("a call of '" + callee.name + "' with " + std::to_string(operands.size()) +
                                " arguments");
  Call call{place, {}};
  for (std::size_t i = 0; i < operands.size(); ++i) call.arguments.push_back(passed(callee.parameters[i], operands[i]));
  const Slot result = target(to);
  if (!gives_scalar) {
    writer_.write({Op::call, 1, result, writer_.add(std::move(call)), 0});
    return result;
  }
  call.arguments.push_back({false, result, 0});
  writer_.write({Op::call, 1, scope_.temporary(), writer_.add(std::move(call)), 0});
  return result;
}

Reference ExpressionCompiler::in_frame(const Expression& name) {
  if (name.kind != Kind::atom) throw std::invalid_argument("a value where a name is expected");
  Reference reference = scope_[name.text];
  if (!reference.is_argument) return reference;
  const Slot copied = writer_.slots(reference.size());
  writer_.load(copied, reference.place, reference.offset, reference.size());
  reference.is_argument = false;
  reference.place = copied;
  return reference;
}

/// status, before.values, state.values, by_one. The state that is moved may be an argument: it comes into the frame and goes back.
Slot ExpressionCompiler::step_of_newton(const std::string& object, const Operands& operands, Wanted to) {
  const Slot* const moving = scope_.scalar(object);
  if (moving == nullptr || operands.size() != 4) throw std::invalid_argument("'" + object + "' takes no step");
  const Slot status = value(operands[0]);
  const Reference before = in_frame(operands[1]), after = in_frame(operands[2]);
  const std::vector<Slot>& by_one = scope_.elements(operands[3].text);
  if (before.size() != by_one.size() || after.size() != by_one.size())
    throw std::invalid_argument("a step between states of several sizes");
  std::vector<std::uint32_t> list{static_cast<std::uint32_t>(by_one.size()), before.place, after.place};
  list.insert(list.end(), by_one.begin(), by_one.end());
  writer_.write({Op::newton, 1, *moving, writer_.list(list), 0});
  copy(after, scope_[operands[2].text]);
  return known(status, to);
}

void ExpressionCompiler::copy(const Reference& from, const Reference& to) {
  const std::size_t count = from.size();
  if (count != to.size()) throw std::invalid_argument("a copy of several sizes");
  if (!from.is_argument && !to.is_argument) return writer_.move(to.place, from.place, count);
  Slot between = from.place;
  if (from.is_argument) {
    between = to.is_argument ? writer_.slots(count) : to.place;
    writer_.load(between, from.place, from.offset, count);
  }
  if (to.is_argument) writer_.store(between, to.place, to.offset, count);
}

// There is one lane, and it is lost where this is called.
void ExpressionCompiler::take_lost(const Operands& operands) {
  if (operands.size() != 3) throw std::invalid_argument("take_lost of other than three arguments");
  copy(scope_[operands[1].text], scope_[operands[2].text]);
}

namespace {

RankRuleKind kind_of(const std::string& rule) {
  if (rule == "rank_on_positions<S>") return RankRuleKind::positions;
  if (rule == "rank_of_velocities<S>") return RankRuleKind::velocities;
  if (rule == "rank_of_steps<S>") return RankRuleKind::steps;
  throw std::invalid_argument("the rank rule '" + rule + "'");
}

}  // namespace

/// The system and its rank rule, the first two arguments.
Solve ExpressionCompiler::solve_of(const Operands& operands) {
  const std::string& system = operands[0].text;
  if (scope_[system].is_argument || scope_[system].layout == nullptr)
    throw std::invalid_argument("the system '" + system + "' is no struct of the function");
  const auto member = [&](const char* name) { return scope_[system + "." + name]; };
  const Shape shape = member("b").shape;
  if (shape.size() != 2) throw std::invalid_argument("a system whose constraints are no matrix");
  Solve solve;
  solve.rows = static_cast<int>(shape[0]);
  solve.speeds = static_cast<int>(shape[1]);
  if (solve.rows > k_most_of_system || solve.speeds > k_most_of_system)
    throw std::invalid_argument("more than " + std::to_string(k_most_of_system) +
                                " speeds or constraints to solve for");
  solve.g = member("g").place;
  solve.f = member("f").place;
  solve.b = member("b").place;
  solve.reach = member("reach").place;
  solve.of_positions = member("of_positions").place;
  solve.off = member("off").place;
  solve.drift = member("drift").place;
  solve.drift_error = member("drift_error").place;
  const Expression& rule = operands[1];
  if (rule.operands.empty()) throw std::invalid_argument("a rank rule without a rank");
  solve.rule = kind_of(rule.text);
  solve.usual = writer_.integers(rule.operands[0].text);
  solve.has_tolerance = rule.operands.size() > 1;
  if (!solve.has_tolerance) return solve;
  const Expression& tolerance = rule.operands[1];
  if (tolerance.text != "rank_tolerance<S>" || tolerance.operands.size() != 1)
    throw std::invalid_argument("the tolerance '" + tolerance.text + "'");
  solve.tolerance = value(tolerance.operands[0]);
  return solve;
}

void ExpressionCompiler::solve(const Operands& operands) {
  if (operands.size() != 3) throw std::invalid_argument("solve of other than three arguments");
  Solve solve = solve_of(operands);
  const Reference solution = scope_[operands[2].text];
  if (solution.is_argument || solution.layout == nullptr || solution.layout->name != "LinearSolution")
    throw std::invalid_argument("solve into '" + operands[2].text + "'");
  solve.solution = solution.place;
  writer_.write({Op::solve, 1, 0, writer_.add(solve), 0});
}

Slot ExpressionCompiler::solve_each(const Operands& operands, Wanted to) {
  if (operands.size() != 5) throw std::invalid_argument("solve_each of other than five arguments");
  Solve solve = solve_of(operands);
  const Reference forces = in_frame(operands[2]), drifts = in_frame(operands[3]), rates = scope_[operands[4].text];
  if (rates.is_argument || rates.shape.size() != 2)
    throw std::invalid_argument("solve_each into '" + operands[4].text + "'");
  solve.sides = static_cast<int>(rates.shape[0]);
  solve.forces = forces.place;
  solve.drifts = drifts.place;
  solve.solution = rates.place;
  const Slot result = target(to);
  writer_.write({Op::solve_each, 1, result, writer_.add(solve), 0});
  return result;
}

}  // namespace gausssim
