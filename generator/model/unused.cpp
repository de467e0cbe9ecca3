// Names that are declared, and that nothing uses: mostly something was forgotten, or misspelt as another name that exists.

#include "model/unused.hpp"

#include <fmt/format.h>

#include <set>

#include "model/expressions.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

/// What expressions name, and those of what is broken in this regime.
class Uses {
 public:
  explicit Uses(const Model& model) {
    for_each_expression(model, [&](const Ast& ast, const Place&) { collect(ast); });
    for_each_expression_of_broken(model, [&](const Ast& ast) { collect(ast); });
  }

  bool has(const Name& name) const { return names_.count(name.text) > 0; }
  bool has(const support::Table* table) const { return tables_.count(table) > 0; }

 private:
  void collect(const Ast& ast) {
    if (ast.kind == AstKind::symbol) names_.insert(ast.name);
    if (ast.table != nullptr) tables_.insert(ast.table.get());
    for (const Ast& child : ast.children) collect(child);
  }

  std::set<std::string> names_;
  std::set<const support::Table*> tables_;
};

/// Of the first file alone: a model may take a part without all that is in it.
class Reporter {
 public:
  Reporter(const support::Source& source, support::Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  void report(const Name& name, const char* kind, const std::string& hint) {
    if (source_.name_at(name.span.begin) != source_.name()) return;
    diagnostics_.warning(support::code::k_unused, name.span,
                         fmt::format("no expression uses the {} '{}'", kind, name.text), hint);
  }

 private:
  const support::Source& source_;
  support::Diagnostics& diagnostics_;
};

/// What several effects have in common can stand in none of them.
bool belongs_to_several_effects(const Name& name, const Model& model) {
  const auto found = model.words_of_absent_effects.find(name.text);
  return found != model.words_of_absent_effects.end() && found->second.size() > 1;
}

/// Where an effect uses it that does not act, code is emitted for nothing.
std::string hint_for(const Name& name, const Model& model, const char* otherwise) {
  const auto found = model.words_of_absent_effects.find(name.text);
  if (found == model.words_of_absent_effects.end()) return otherwise;
  return fmt::format("the effect '{}', which does not act, mentions it: declare it there", found->second.front());
}

}  // namespace

void check_uses(const Model& model, const support::Source& source, support::Diagnostics& diagnostics) {
  const Uses uses(model);
  Reporter reporter(source, diagnostics);
  for (const Table& table : model.tables) {
    if (uses.has(table.function.get())) continue;
    reporter.report(table.name, "table", fmt::format("write {}(x), or remove it", table.name.text));
  }
  for (const Parameter& parameter : model.parameters) {
    if (!uses.has(parameter.name) && !belongs_to_several_effects(parameter.name, model))
      reporter.report(parameter.name, "parameter", hint_for(parameter.name, model, "use it, or remove it"));
  }
  for (const Input& input : model.inputs) {
    if (uses.has(input.name) || belongs_to_several_effects(input.name, model)) continue;
    reporter.report(input.name, "input", hint_for(input.name, model, "let a force or a quantity use it, or remove it"));
  }
}

}  // namespace gaussgen::model
