#pragma once
// Statements of one function of a header as instructions.

#include "sim/interpreter/expression_compiler.hpp"

namespace gausssim {

/// Throws std::invalid_argument for what there are no instructions for.
class FunctionCompiler {
 public:
  explicit FunctionCompiler(Writer& writer) : writer_(writer), scope_(writer), expressions_(writer, scope_) {}

  void compile(const gaussgen::emit::cpp::Function& function);
  /// What `type<S>{}` gives, as a function of the name of the struct.
  void compile_defaults(const gaussgen::emit::cpp::Struct& type);

 private:
  using Statement = gaussgen::emit::cpp::Statement;

  void add_parameter(const gaussgen::emit::cpp::Argument& argument, Function& function);
  void bind_parameters(const Function& function);
  void bind_parameter(const Parameter& parameter, std::size_t argument, bool is_returned);

  void write(const Statement& statement);
  void statement(const gaussgen::emit::cpp::Definition& definition);
  void statement(const gaussgen::emit::cpp::Declaration& declaration);
  void statement(const gaussgen::emit::cpp::Assignment& assignment);
  void statement(const gaussgen::emit::cpp::Evaluation& evaluation);
  void statement(const gaussgen::emit::cpp::Return& end);
  void statement(const gaussgen::emit::cpp::EarlyReturn& end);
  void statement(const gaussgen::emit::cpp::Array& array);
  void statement(const gaussgen::emit::cpp::Loop& loop);
  void statement(const gaussgen::emit::cpp::Alias& alias);
  void statement(const gaussgen::emit::cpp::BlankLine&) {}
  void statement(const gaussgen::emit::cpp::Comment&) {}

  void define_scalar(const gaussgen::emit::cpp::Definition& definition, bool is_reference);
  void define_numbers(const gaussgen::emit::cpp::Definition& definition);
  bool replace(const Reference& target, const gaussgen::emit::cpp::Assignment& assignment);
  void give(const gaussgen::emit::cpp::Expression& value);
  const Layout* layout(const std::string& type) const;

  Writer& writer_;
  Scope scope_;
  ExpressionCompiler expressions_;
  std::string type_;    ///< of what is returned
  Reference returned_;  ///< where that goes, if it is no status
  bool has_ended_ = false;
};

}  // namespace gausssim
