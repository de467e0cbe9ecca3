#pragma once
// What is generated: a model, or that of a scene with what the scene chooses.

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "scene_choice.hpp"
#include "support/source.hpp"

namespace gaussgen::cli {

struct Input {
  Options options;  ///< with what a scene says; `model` is that of the scene then
  support::Source source;
  std::optional<support::Source> scene = std::nullopt;
  std::vector<support::Span> places = {};  ///< of the effects' words in it; empty where options choose
  bool are_effects_of_options = false;     ///< whatever the scene says
  SceneChoice choice = {};                 ///< of the scene; with instances where it is of several motions
};

/// Values of a scene that its model does not take, at their places.
class WrongScene : public std::runtime_error {
 public:
  explicit WrongScene(support::Diagnostics found) : runtime_error("wrong scene"), found_(std::move(found)) {}

  const support::Diagnostics& found() const { return found_; }

 private:
  support::Diagnostics found_;
};

/// Nothing where the scene has mistakes: they are reported, and `code` is the exit code. Throws FileError, and UsageError for an instance that is not there.
std::optional<Input> read_input(const Options& options, int& code);

/// Gives a model the values of a scene; those of effects that do not act are passed over. Throws WrongScene.
void give_values(const std::vector<SceneValue>& values, model::Model& to);

}  // namespace gaussgen::cli
