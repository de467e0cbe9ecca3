#pragma once
// The statements of one emitted function.

#include <string>
#include <unordered_map>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/expression.hpp"
#include "passes/program.hpp"

namespace gaussgen::emit {

/// Names the temporaries of a program and prints their definitions.
class Body {
 public:
  /// `scope`: of the whole function, which may have several programs.
  Body(const passes::Writing& writing, const UnitNames& names, NameScope& scope);

  /// `name`, which is taken in the scope, belongs to the definition of `id`.
  void reserve(NodeId id, const std::string& name) { reserved_.emplace(id.index, name); }

  void define(const passes::Program& program);
  /// `const Bool name = condition;`, or nothing for what cannot happen; returns what to pass on.
  cpp::Expression define_condition(NodeId id, const std::string& name);

  cpp::Expression value(NodeId id) const { return writer_.value(id); }
  /// What it may be called; empty where nothing comes to mind.
  std::string natural_name_for(NodeId id) const;
  void add(cpp::Statement statement) { statements_.push_back(std::move(statement)); }
  void blank_line();

  std::size_t size() const { return statements_.size(); }
  std::vector<cpp::Statement> take() { return std::move(statements_); }

 private:
  using Assignments = std::vector<passes::Assignment>;

  void define(const passes::Assignment& assignment);
  /// Sines and cosines from `first` on that do not depend on each other.
  std::size_t angles_from(const Assignments& assignments, std::size_t first) const;
  void define_angles(const Assignments& assignments, std::size_t first, std::size_t count);
  std::string name_for(NodeId id, const std::string& wanted);

  const passes::Writing& writing_;
  const UnitNames& names_;
  ExpressionWriter writer_;
  NameScope& scope_;
  std::unordered_map<std::uint32_t, std::string> reserved_;
  std::vector<cpp::Statement> statements_;
};

/// Puts `using Bool = …;` in front where a statement defines a condition, or the status that is returned is made of some.
void name_type_of_conditions(std::vector<cpp::Statement>& statements, bool is_returned = false);

}  // namespace gaussgen::emit
