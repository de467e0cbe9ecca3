#pragma once
// Expressions of a header as instructions: in the order in which C++ evaluates them, each operation rounded by itself.

#include <optional>
#include <string>
#include <vector>

#include "sim/interpreter/scope.hpp"
#include "sim/interpreter/writer.hpp"

namespace gausssim {

/// Throws std::invalid_argument for what there are no instructions for.
class ExpressionCompiler {
 public:
  using Expression = gaussgen::emit::cpp::Expression;

  ExpressionCompiler(Writer& writer, Scope& scope) : writer_(writer), scope_(scope) {}

  /// Where the value is: that of a name, of a constant, or a temporary one.
  Slot value(const Expression& expression) { return compiled(expression, std::nullopt); }
  /// Puts it there; `to` may not be read in the expression.
  void put(const Expression& expression, Slot to) { (void)compiled(expression, to); }

  /// What stands alone: sines and cosines, calls whose status nobody looks at.
  void evaluate(const Expression& call);

  /// Scalars from here to there, of the same number.
  void copy(const Reference& from, const Reference& to);

 private:
  using Wanted = std::optional<Slot>;
  using Operands = std::vector<Expression>;

  Slot compiled(const Expression& expression, Wanted to);
  Slot atom(const std::string& text, Wanted to);
  Slot known(Slot constant, Wanted to);
  Slot negation(const Expression& operand, Wanted to);
  Slot sum(const Operands& terms, Wanted to);
  Slot product(const Operands& factors, Op last, Wanted to);
  Slot quotient(const Operands& both, Wanted to);
  void add(const Expression& term, Slot sum);
  Slot operation(Op op, Wanted to, Slot a, Slot b = 0);
  Slot target(Wanted to) { return to ? *to : scope_.temporary(); }

  Slot call(const std::string& callee, const Operands& operands, Wanted to);
  Slot function_of_math(const std::string& name, const Operands& operands, Wanted to);
  Slot literal(const Operands& operands);
  Slot pieces(const Operands& operands);
  Slot select(const Operands& operands, Wanted to);
  Slot any(const Operands& operands, Wanted to);
  Slot not_finite(const Operands& operands, Wanted to);
  Slot status(const Operands& operands, Wanted to);
  void sincos(const Operands& operands);

  // calls.cpp
  Slot call_of_header(int function, const Operands& operands, Wanted to);
  Passed passed(const Parameter& parameter, const Expression& argument);
  Slot step_of_newton(const std::string& object, const Operands& operands, Wanted to);
  void solve(const Operands& operands);
  Slot solve_each(const Operands& operands, Wanted to);
  Solve solve_of(const Operands& operands);
  void take_lost(const Operands& operands);
  /// The scalars of a name, which are in the frame.
  Reference in_frame(const Expression& name);

  Writer& writer_;
  Scope& scope_;
};

/// The number in the text of a literal. Throws std::invalid_argument.
double number_in(const std::string& text);

}  // namespace gausssim
