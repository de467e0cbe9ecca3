#pragma once
// A scene in place of a model: which model, with which effects and values. What else is in a scene is for simulations (docs/scenes.md).

#include <optional>
#include <string>
#include <vector>

#include "instance_choice.hpp"
#include "model/choices.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// Of a parameter, an input or the start.
struct SceneValue {
  std::string name, text;
  support::Span span;  ///< of the name
  bool is_of_start = false;
};

/// One of several bodies of the model: what it says beside its scene.
struct InstanceOfScene {
  std::string name;
  support::Span span;  ///< of the name
  std::vector<PlacedWord> effects;
  std::vector<SceneValue> values;
};

struct SceneChoice {
  std::string name;   ///< as a name of C++; of the file where the scene has none
  std::string model;  ///< path
  model::GivenCounts counts;
  std::vector<PlacedWord> effects;
  std::vector<SceneValue> values;
  std::vector<InstanceOfScene> instances;
  support::Span instances_place;  ///< of the key
};

/// What a scene may have, and one of its instances: times, rows and number types are those of all, since they are rows of one table.
const std::vector<std::string>& keys_of_scenes();
const std::vector<std::string>& keys_of_instances();

/// Whether the file is a scene, which names a model, and not a model itself. False for what is no YAML either: reading it as a model says what is wrong.
bool is_scene(const support::Source& source);

/// A file that a scene, or another file, names: from the folder of that.
std::string beside(const std::string& file, const std::string& named);

/// The scene as one of its instances; null: it has none of this name.
const InstanceOfScene* find_instance(const SceneChoice& scene, const std::string& name);

/// What the scene says for this one, as if it said it for itself: effects, and values of which the later one counts.
SceneChoice as_instance(const SceneChoice& scene, const InstanceOfScene& one);

/// Nothing where it has mistakes, which are in `diagnostics`.
std::optional<SceneChoice> read_scene_choice(const support::Source& scene, support::Diagnostics& diagnostics);

}  // namespace gaussgen
