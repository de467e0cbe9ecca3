#include "undefined_parts.hpp"

#include "model/expressions.hpp"
#include "model/functions.hpp"

namespace gaussgen {

namespace {

using model::Ast;

class Search {
 public:
  Search(Mechanics& mechanics, ModelValues& values, int derivative)
      : mechanics_(mechanics), values_(values), derivative_(derivative) {}

  std::vector<UndefinedPart> run() {
    model::for_each_expression(mechanics_.model, [&](const Ast& ast, const model::Place&) { look_into(ast); });
    return std::move(found_);
  }

 private:
  std::optional<evaluate::Trouble> trouble(const Ast& ast) {
    ir::Expr expression = mechanics_.expressions(ast);
    for (int i = 0; i < derivative_; ++i) expression = mechanics_.expressions.rate(expression);
    return values_.trouble(expression.id());
  }

  /// All of `ast`, or of cases the conditions up to the first that holds, and its value.
  std::vector<const Ast*> computed_parts(const Ast& ast) {
    const bool has_cases = ast.kind == model::AstKind::call && ast.name == model::k_piecewise;
    std::vector<const Ast*> parts;
    for (std::size_t i = 0; i < ast.children.size(); ++i) {
      parts.push_back(&ast.children[i]);
      const bool is_condition = has_cases && i % 2 == 0 && i + 1 < ast.children.size();
      if (!is_condition) continue;
      const ir::Expr condition = mechanics_.expressions(ast.children[i]);
      const bool holds = !values_.trouble(condition.id()) && values_.is_true(condition);
      if (holds) {
        parts.push_back(&ast.children[i + 1]);
        return parts;
      }
      ++i;  // the value of a case that is not chosen
    }
    return parts;
  }

  /// Whether something in `ast` is reported.
  bool look_into(const Ast& ast) {
    const auto trouble = this->trouble(ast);
    if (!trouble) return false;
    for (const Ast* part : computed_parts(ast)) {
      if (look_into(*part)) return true;
    }
    if (trouble->reason == evaluate::reason::k_unbound) return false;
    const bool is_quotient = ast.kind == model::AstKind::reciprocal;
    found_.push_back({is_quotient ? ast.children[0].span : ast.span, trouble->reason});
    return true;
  }

  Mechanics& mechanics_;
  ModelValues& values_;
  int derivative_;
  std::vector<UndefinedPart> found_;
};

}  // namespace

std::vector<UndefinedPart> undefined_parts(Mechanics& mechanics, ModelValues& values, int derivative) {
  return Search(mechanics, values, derivative).run();
}

}  // namespace gaussgen
