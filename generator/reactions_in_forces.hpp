#pragma once
// Reactions that forces depend on, which depend on forces themselves, as those of friction: found from linear equations.

#include <optional>
#include <vector>

#include "ir/expr.hpp"
#include "model/model.hpp"

namespace gaussgen {

struct Mechanics;

/// As the solution of `mechanics` has it; 0 where there is none in this regime.
ir::Expr reaction_of(const Mechanics& mechanics, const model::NamedReaction& of);

/// Each reaction of Model::reactions as a function of the state: `mechanics` was formed with symbols in their place, in which its
/// solution is linear. Nothing where the equations say nothing of them (theory.md, section 10).
std::optional<std::vector<ir::Expr>> found_reactions(Mechanics& mechanics);

}  // namespace gaussgen
