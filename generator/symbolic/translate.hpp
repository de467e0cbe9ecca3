#pragma once
// What a user wrote, as GiNaC sees it. GiNaC never reads the user's text: the checked syntax tree is translated.

#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <string>

#include "model/ast.hpp"

namespace gaussgen::symbolic {

/// What the names of an expression mean, those with a point in them too, and what `dot` does to its argument.
struct Scope {
  std::map<std::string, GiNaC::ex> values;
  std::function<GiNaC::ex(const GiNaC::ex&)> dot;
  std::function<GiNaC::ex(const std::string&)> place;  ///< tip.x
  std::map<std::string, unsigned> tables = {};         ///< index in the model
};

GiNaC::ex translate(const model::Ast& ast, const Scope& scope);

}  // namespace gaussgen::symbolic
