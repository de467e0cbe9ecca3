#include "emit/operations.hpp"

#include <algorithm>
#include <array>

namespace gaussgen::emit {

using cpp::Expression;

namespace {

using Kind = Expression::Kind;

constexpr int k_arguments_of_angle = 3;  ///< itself, its sine, its cosine

// A literal of the scalar type: compilers divide two of them.
bool is_number(const Expression& e) { return e.kind == Kind::call && e.text == "S"; }

bool is_free(const std::string& callee) {
  static constexpr std::array k_free{"less",   "at_most", "select",  "any",      "not_finite",
                                     "status", "worse",   "epsilon", "constant", "pi"};
  return std::any_of(k_free.begin(), k_free.end(),
                     [&](const char* name) { return callee == "Math<S>::" + std::string(name); });
}

class Tally {
 public:
  explicit Tally(const std::map<std::string, Operations>& callees) : callees_(callees) {}

  void add(const Expression& e) {
    const int count = static_cast<int>(e.operands.size());
    switch (e.kind) {
      case Kind::sum: operations.additions += count - 1; break;
      case Kind::product: operations.multiplications += count - 1; break;
      case Kind::quotient: operations.divisions += is_number(e.operands[0]) && is_number(e.operands[1]) ? 0 : 1; break;
      case Kind::call: add_call(e.text, count); break;
      default: break;
    }
    for (const Expression& operand : e.operands) add(operand);
  }

  Operations operations;

 private:
  void add_call(const std::string& callee, int count) {
    if (const auto own = callees_.find(callee); own != callees_.end()) return add(own->second);
    if (callee == "Angles<S>::sincos") {
      operations.functions += 2 * count / k_arguments_of_angle;
      return;
    }
    if (callee.rfind("Math<S>::", 0) != 0 || is_free(callee)) return;
    if (callee == "Math<S>::sqrt") {
      ++operations.square_roots;
    } else {
      operations.functions += callee == "Math<S>::sincos" ? 2 : 1;
    }
  }

  void add(const Operations& other) {
    operations.additions += other.additions;
    operations.multiplications += other.multiplications;
    operations.divisions += other.divisions;
    operations.square_roots += other.square_roots;
    operations.functions += other.functions;
  }

  const std::map<std::string, Operations>& callees_;
};

}  // namespace

namespace {

/// Of a loop whose end is found at run time, one round counts.
int times(const cpp::Loop& loop) {
  const bool is_known = loop.to.find_first_not_of("0123456789") == std::string::npos;
  return is_known ? std::stoi(loop.to) - std::stoi(loop.from) : 1;
}

void add(const cpp::Statement& statement, Tally& tally) {
  if (const auto* definition = std::get_if<cpp::Definition>(&statement)) tally.add(definition->value);
  if (const auto* assignment = std::get_if<cpp::Assignment>(&statement)) tally.add(assignment->value);
  if (const auto* evaluation = std::get_if<cpp::Evaluation>(&statement)) tally.add(evaluation->expression);
  if (const auto* result = std::get_if<cpp::Return>(&statement)) tally.add(result->value);
  const auto* loop = std::get_if<cpp::Loop>(&statement);
  if (loop == nullptr) return;
  for (int time = 0; time < times(*loop); ++time) {
    for (const cpp::AnyStatement& inner : loop->body) add(inner.statement, tally);
  }
}

}  // namespace

Operations operations_of(const std::vector<cpp::Statement>& statements,
                         const std::map<std::string, Operations>& callees) {
  Tally tally(callees);
  for (const cpp::Statement& statement : statements) add(statement, tally);
  return tally.operations;
}

Operations operations_of(const cpp::Function& function, const std::map<std::string, Operations>& callees) {
  return operations_of(function.body, callees);
}

int total(const Operations& operations) {
  return operations.additions + operations.multiplications + operations.divisions + operations.square_roots +
         operations.functions;
}

std::vector<Operations> operations_of_all(const std::vector<cpp::Function>& functions,
                                          std::map<std::string, Operations> callees) {
  std::vector<Operations> counts;
  for (const cpp::Function& function : functions) {
    counts.push_back(operations_of(function, callees));
    callees.insert_or_assign(function.name, counts.back());
  }
  return counts;
}

}  // namespace gaussgen::emit
