#pragma once
// Shared by the tests of this folder.

#include <string>

#include "model/build.hpp"
#include "model/parser.hpp"

namespace test {

inline const std::string k_header = "gauss: 1\nname: test\n";
inline const std::string k_x = "coordinates: {x: {}}\n";
inline const std::string k_particle = "particles: {p: {mass: 1, position: [x, 0, 0]}}\n";

/// One particle on a line, and what a test adds.
inline std::string with(const std::string& more) { return k_header + k_x + k_particle + more; }

struct Built {
  gaussgen::support::Source source;
  gaussgen::support::Diagnostics diagnostics;
  std::optional<gaussgen::model::Model> model;

  explicit Built(const std::string& text, const std::string& name = "m.yaml")
      : Built(gaussgen::support::Source(name, text)) {}

  explicit Built(gaussgen::support::Source of)
      : source(std::move(of)), model(gaussgen::model::build_model(source, diagnostics)) {}

  /// All codes in the order of the checks: "E031 E040".
  std::string codes() const {
    std::string text;
    for (const auto& finding : diagnostics.all()) text += (text.empty() ? "" : " ") + finding.code;
    return text;
  }
};

/// (+ a (* b (/ c))): the tree in brackets.
inline std::string show(const gaussgen::model::Ast& ast) {
  using gaussgen::model::AstKind;
  std::string text;
  switch (ast.kind) {
    case AstKind::number: return gaussgen::support::to_text(ast.number);
    case AstKind::symbol: return ast.name;
    case AstKind::negate: text = "-"; break;
    case AstKind::sum: text = "+"; break;
    case AstKind::product: text = "*"; break;
    case AstKind::reciprocal: text = "/"; break;
    case AstKind::power: text = "^"; break;
    case AstKind::call:
    case AstKind::comparison: text = ast.name; break;
  }
  for (const auto& child : ast.children) text += " " + show(child);
  return "(" + text + ")";
}

struct Parsed {
  gaussgen::support::Diagnostics diagnostics;
  std::optional<gaussgen::model::Ast> ast;

  explicit Parsed(const std::string& text)
      : ast(gaussgen::model::parse_expression(gaussgen::spec::located(text), diagnostics)) {}

  /// The tree, or the code and the column of the only error.
  std::string result() const {
    if (ast) return show(*ast);
    if (diagnostics.all().size() != 1) return std::to_string(diagnostics.all().size()) + " errors";
    return diagnostics.all()[0].code + "@" + std::to_string(diagnostics.all()[0].span.begin);
  }
};

inline std::string parsed(const std::string& text) { return Parsed(text).result(); }

}  // namespace test
