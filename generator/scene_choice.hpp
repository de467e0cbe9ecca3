#pragma once
// A scene in place of a model: which model, with which effects and values. What else is in a scene is for simulations (docs/scenes.md).

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/choices.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

struct SceneChoice {
  std::string name;   ///< as a name of C++; of the file where the scene has none
  std::string model;  ///< path
  model::GivenCounts counts;
  model::GivenEffects effects;
  std::vector<support::Span> places;                        ///< of each word of `effects`
  std::vector<std::pair<std::string, std::string>> values;  ///< of parameters, inputs and the start
};

/// Whether the file is a scene, which names a model, and not a model itself. False for what is no YAML either: reading it as a model says what is wrong.
bool is_scene(const support::Source& source);

/// A file that a scene, or another file, names: from the folder of that.
std::string beside(const std::string& file, const std::string& named);

/// Nothing where it has mistakes, which are in `diagnostics`.
std::optional<SceneChoice> read_scene_choice(const support::Source& scene, support::Diagnostics& diagnostics);

}  // namespace gaussgen
