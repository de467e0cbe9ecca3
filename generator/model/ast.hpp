#pragma once
// Expressions of a model file as the user wrote them, with byte spans.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/rational.hpp"
#include "support/source.hpp"
#include "support/table.hpp"

namespace gaussgen::model {

enum class AstKind {
  number,      ///< exact: "0.1" is 1/10
  symbol,      ///< a declared name, `t`, or `pi`
  negate,      ///< -a
  sum,         ///< a + b + …; a subtracted term is a `negate` child
  product,     ///< a * b * …; a divisor is a `reciprocal` child
  reciprocal,  ///< 1 / a
  power,       ///< a ^ e, e an integer or rational constant expression
  call,        ///< f(a, …); `dot(a)` is the total time derivative
  comparison,  ///< a < b; a condition of `piecewise`, and nothing else
};

/// One node. Sums and products are n-ary, so that the depth is the nesting of brackets and never the
/// length of the text; the parser bounds it.
struct Ast {
  AstKind kind = AstKind::number;
  support::Span span;
  support::Rational number = 0;  ///< kind number
  bool is_decimal = false;       ///< kind number: written with a decimal point or an exponent
  std::string text = {};         ///< of a whole expression, where it is not what the file has at `span`
  bool is_derived = false;       ///< stands for a shorthand of the format; its span is that of the shorthand
  std::string name;              ///< kind symbol: the name; kind call: the function; kind comparison: < <= > >=
  std::shared_ptr<const support::Table> table;  ///< kind call: where the function is a table of the model
  std::vector<Ast> children;
};

inline Ast number(support::Rational value, support::Span span = {}) {
  Ast ast;
  ast.span = span;
  ast.number = std::move(value);
  return ast;
}

/// The tables of a model by name; null where one is faulty, which is reported.
using KnownTables = std::map<std::string, std::shared_ptr<const support::Table>>;

/// Stands for an expression with a mistake that is reported already; later checks pass over it, except for the names in
/// `readable`, the parts that could be read. No model that is handed on holds one.
inline Ast broken_expression(std::vector<Ast> readable = {}) {
  Ast ast;
  ast.kind = AstKind::symbol;
  ast.children = std::move(readable);
  return ast;
}

/// Of a comparison; of numbers that are none, nothing holds.
template <class Number>
bool holds(const std::string& comparison, const Number& a, const Number& b) {
  if (comparison == "<") return a < b;
  if (comparison == "<=") return a <= b;
  return comparison == ">" ? b < a : b <= a;
}

/// A whole expression as the file has it, or as repetition and submodels made it.
inline std::string_view words_of(const Ast& ast, const support::Source& source) {
  return ast.text.empty() ? source.text(ast.span) : std::string_view(ast.text);
}

inline bool is_broken(const Ast& ast) { return ast.kind == AstKind::symbol && ast.name.empty(); }

}  // namespace gaussgen::model
