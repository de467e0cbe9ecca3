#pragma once
// Expressions that a shorthand of the format stands for, at the place where the user wrote it. Private to the folder.

#include "model/model.hpp"

namespace gaussgen::model {

inline Ast node_of(AstKind kind, support::Span span, std::vector<Ast> children = {}) {
  Ast ast;
  ast.kind = kind;
  ast.span = span;
  ast.is_derived = true;
  ast.children = std::move(children);
  return ast;
}

inline Ast symbol_of(const std::string& name, support::Span span) {
  Ast ast = node_of(AstKind::symbol, span);
  ast.name = name;
  return ast;
}

inline Ast sum_of(Ast a, Ast b) {
  const support::Span span = b.span;
  std::vector<Ast> terms;
  terms.push_back(std::move(a));
  terms.push_back(std::move(b));
  return node_of(AstKind::sum, span, std::move(terms));
}

inline Ast product_of(Ast a, Ast b) {
  Ast product = sum_of(std::move(a), std::move(b));
  product.kind = AstKind::product;
  return product;
}

inline Ast negative_of(Ast a) {
  const support::Span span = a.span;
  std::vector<Ast> inner;
  inner.push_back(std::move(a));
  return node_of(AstKind::negate, span, std::move(inner));
}

inline Ast difference_of(Ast a, Ast b) { return sum_of(std::move(a), negative_of(std::move(b))); }

inline Ast square_of(Ast a) {
  const support::Span span = a.span;
  Ast two = node_of(AstKind::number, span);
  two.number = 2;
  std::vector<Ast> children;
  children.push_back(std::move(a));
  children.push_back(std::move(two));
  return node_of(AstKind::power, span, std::move(children));
}

inline Ast call_of(const std::string& function, Ast argument) {
  const support::Span span = argument.span;
  std::vector<Ast> children;
  children.push_back(std::move(argument));
  Ast ast = node_of(AstKind::call, span, std::move(children));
  ast.name = function;
  return ast;
}

/// `tip.x`; the origin of space has none, its components are 0.
inline Ast component_of(const Name& place, std::size_t axis) {
  if (place.text != "space") return symbol_of(place.text + "." + "xyz"[axis], place.span);
  return node_of(AstKind::number, place.span);
}

inline Ast distance_between(const Name& a, const Name& b) {
  std::vector<Ast> squares;
  for (std::size_t i = 0; i < 3; ++i)
    squares.push_back(square_of(difference_of(component_of(a, i), component_of(b, i))));
  return call_of("sqrt", node_of(AstKind::sum, b.span, std::move(squares)));
}

}  // namespace gaussgen::model
