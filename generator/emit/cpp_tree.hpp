#pragma once
// The C++ that is emitted, as a tree. Text with punctuation is put together by the printer only.

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gaussgen::emit::cpp {

struct Expression {
  enum class Kind {
    atom,      ///< text: a name, a member access, a literal
    negation,  ///< -operands[0]
    sum,       ///< Σ operands; a negation among them is a subtraction
    product,   ///< Π operands
    quotient,  ///< operands[0] / operands[1]
    call,      ///< text(operands...)
    list,      ///< {operands...}
  };
  Kind kind = Kind::atom;
  std::string text;
  std::vector<Expression> operands;
};

inline Expression atom(std::string text) { return {Expression::Kind::atom, std::move(text), {}}; }
inline Expression call(std::string callee, std::vector<Expression> arguments) {
  return {Expression::Kind::call, std::move(callee), std::move(arguments)};
}
inline Expression list(std::vector<Expression> items) { return {Expression::Kind::list, {}, std::move(items)}; }

/// Cancels a double minus.
Expression negated(Expression operand);
/// A lone operand stands for itself. Signs of factors, top and bottom go in front of the whole, where they cancel or become subtractions:
/// a second minus behind a first one would be a decrement.
Expression product(std::vector<Expression> factors);
Expression quotient(Expression top, Expression bottom);
Expression sum(std::vector<Expression> terms);

/// `type name = value;`
struct Definition {
  std::string type;
  std::string name;
  Expression value;
};

/// `type name, name;`
struct Declaration {
  std::string type;
  std::vector<std::string> names;
};

/// `using name = type;`
struct Alias {
  std::string name;
  std::string type;
};

struct Assignment {
  Expression target;
  Expression value;
};

struct Evaluation {
  Expression expression;
};

struct Return {
  Expression value;
};

struct BlankLine {};

/// One line comment per line of text.
struct Comment {
  std::string text;
};

/// `const type name[…][…] = {{…}, …};`, rows of one length.
struct Array {
  std::string type;
  std::string name;
  std::vector<std::vector<Expression>> rows;
};

struct AnyStatement;

/// `for (int index = from; index < to && condition; ++index) {…}`
struct Loop {
  std::string index;
  std::string from;
  std::string to;
  std::vector<AnyStatement> body;
  std::string condition = {};
};

/// `if (condition) return value;`
struct EarlyReturn {
  Expression condition;
  Expression value;
};

using Statement = std::variant<Definition, Declaration, Alias, Assignment, Evaluation, Return, EarlyReturn, BlankLine,
                               Comment, Array, Loop>;

/// A Statement before the type is complete.
struct AnyStatement {
  Statement statement;
};

struct Argument {
  std::string type;
  std::string name;
  bool is_used = true;
};

struct Function {
  std::string comment;
  bool is_template = true;  ///< over `class S`
  bool is_member = false;   ///< printed on one line, without template head
  std::string prefix;       ///< GAUSS_FUNCTION
  std::string type;
  std::string name;
  std::vector<Argument> arguments;
  std::string suffix;  ///< const noexcept
  std::vector<Statement> body;
};

struct Struct;

/// `type name[2][3] = value;  ///< comment`
struct Member {
  std::string type;
  std::string name;
  std::vector<std::string> shape;
  std::optional<Expression> value;
  std::string comment;
};

struct Struct {
  std::string comment;
  bool is_template = true;
  std::string name;
  std::vector<Struct> nested;  ///< each followed by a member of its type
  std::vector<Member> members;
  std::vector<Function> functions;
  std::string instance;  ///< of a nested struct: the member that has its type
};

/// `inline constexpr type name = value;`
struct Constant {
  std::string type;
  std::string name;
  Expression value;
  std::string comment;
};

/// `inline constexpr type name[] = {{…}, …};`
struct Table {
  std::string comment;
  std::string type;
  std::string name;
  std::vector<std::vector<Expression>> rows;
  bool is_template = false;  ///< over `class S`
};

/// `template type name(arguments) suffix;` of a function template, with a scalar type in place of S.
struct Instantiation {
  const char* prefix = "";  ///< extern
  std::string scalar;
  Function function;  ///< its body is not printed
};

/// Lines that are printed as they are: preprocessor directives and the embedded prelude.
struct Verbatim {
  std::string text;
};

using Item = std::variant<Comment, BlankLine, Verbatim, Constant, Table, Struct, Function, Instantiation>;

struct File {
  std::vector<Item> before;  ///< the namespace
  std::string name_space;
  std::vector<Item> items;
  std::vector<Item> after;
};

}  // namespace gaussgen::emit::cpp
