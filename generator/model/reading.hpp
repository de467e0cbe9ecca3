#pragma once
// What the readers of the sections share while a model is built. Private to the folder.

#include <map>
#include <string>

#include "model/model.hpp"
#include "spec/node.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

struct Declared {
  support::Span span;
  std::string what;  ///< "the parameter"
};

struct Reading {
  const support::Source& source;
  support::Diagnostics& diagnostics;
  Model model;
  std::map<std::string, Declared> declared;
  /// A section that declares names could not be read: an unknown name may be one of its own.
  bool names_incomplete = false;

  std::uint32_t line(support::Span span) const { return source.position(span.begin).line; }
};

/// Stands for an expression that was reported already; later checks pass over it. No model that is
/// handed on holds one.
Ast broken_expression();
bool is_broken(const Ast& ast);

}  // namespace gaussgen::model
