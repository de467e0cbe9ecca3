#pragma once
// Which effects act for one of several bodies of a scene: what it says, on top of what its scene says.

#include <string>
#include <vector>

#include "support/source.hpp"

namespace gaussgen {

/// A word of a choice (model::GivenEffects), and where it stands.
struct PlacedWord {
  std::string text;
  support::Span span;
};

/// Words whose first one has a sign change the scene's choice: what they name is taken out of it, and they are put behind it. Others, as `all` or a plain name
/// first, are a choice of their own; none at all are the scene's.
std::vector<PlacedWord> choice_of_instance(const std::vector<PlacedWord>& of_scene, const std::vector<PlacedWord>& own);

}  // namespace gaussgen
