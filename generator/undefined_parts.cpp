#include "undefined_parts.hpp"

#include "model/expressions.hpp"

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

  /// Whether something in `ast` is reported.
  bool look_into(const Ast& ast) {
    const auto trouble = this->trouble(ast);
    if (!trouble) return false;
    for (const Ast& child : ast.children) {
      if (look_into(child)) return true;
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
