#pragma once
// From a file to a model whose functions can be executed.

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/messages.hpp"
#include "model/model.hpp"
#include "sim/engine/binding.hpp"
#include "sim/engine/plugin.hpp"
#include "sim/output/columns.hpp"
#include "sim/regimes/regime_source.hpp"
#include "sim/run/times.hpp"
#include "sim/scene/scene.hpp"

namespace gausssim {

class AmongInstances;

/// What the command line says beside the file.
struct Request {
  std::string file;               ///< a scene or a model
  std::vector<std::string> sets;  ///< NAME=VALUE
  std::vector<std::string> also;  ///< outputs of the generator that the method needs
  gaussgen::cli::MessageOptions messages;
  std::vector<std::string> where_possible = {};  ///< outputs that are left out without a word where the model has none
  bool leaves_large_series_out = false;          ///< where nobody names a method: see k_most_series_operations
  bool leaves_series_out = false;                ///< where nobody names a method: no engine would run them
  std::string form = {};                         ///< one of the scene's `formulations`; empty: the scene itself
  std::string instance = {};        ///< one of the scene's `instances`; empty: a scene that has some is refused
  AmongInstances* among = nullptr;  ///< what the other instances have found; null: it is alone
  std::optional<gaussgen::support::Source> text = {};  ///< of the file, where it has been read
  /// Changes the model when scene and options have had their say; what it finds is in the text of the scene. May be empty.
  std::function<void(const Scene&, gaussgen::model::Model&, gaussgen::support::Diagnostics&)> adjust = nullptr;
};

struct PreparedModel {
  Scene scene;
  Described model;
  Columns columns;
  std::vector<std::pair<std::string, gaussgen::model::Ast>> parameters;  ///< each over those before it
  Span span;
  std::vector<std::string> effects;                    ///< that act
  std::vector<gaussgen::model::Effect> known_effects;  ///< that the model has, whether they act or not
  std::string model_file;
  std::string model_text;  ///< of that file, and behind it of those that it includes
  double generate_seconds = 0;
  int operations = 0;               ///< of the rates
  int series_operations = 0;        ///< of power series, those of each order once; 0: there are none
  bool acts_in_time = false;        ///< what acts is a function of time, too
  std::string edge;                 ///< a function in what acts that jumps or has a kink; empty: all of it is smooth
  std::array<double, 3> gravity{};  ///< m/s², space: the sum of uniform fields at the start
  std::size_t code = 0;             ///< of instances: which of their codes this one has
  std::shared_ptr<PluginShelf> plugins;  ///< of instances, which share them; else null
  std::shared_ptr<RegimeSource>
      regimes;               ///< of a model whose contacts, friction or links change their modes; else null
  bool wants_gains = false;  ///< the projection `gains` may be asked for

  bool has_effects() const { return !known_effects.empty(); }

  /// Of the scene, else of the model: names files and problems.
  const std::string& name_of_scene() const { return scene.name.empty() ? model.unit.model_name : scene.name; }
  /// In messages.
  std::string in_words() const {
    const std::string name = "'" + model.unit.model_name + "'";
    return scene.instance.empty() ? name : "'" + scene.instance + "' of " + name;
  }
  /// As the scene, and of an instance its own.
  std::string name() const { return name_of_scene() + (scene.instance.empty() ? "" : "." + scene.instance); }
};

/// Throws cli::UsageError for a model whose contacts, friction or links change their modes. `what` does not look for that: "an ensemble".
void refuse_regimes(const PreparedModel& prepared, const char* what);

/// Compilers take more than 4 s for more operations of power series, ten times as long as for everything else, and runs gain a factor of two by them at best: they are no default.
constexpr int k_most_series_operations = 4000;

/// Reads the file; `change` may alter the scene before the model is read, as options do. Nothing after an error, which is reported: `code` is the exit code. Throws
/// cli::FileError and cli::UsageError.
std::optional<PreparedModel> prepare(const Request& request, const std::function<void(Scene&)>& change, int& code);

}  // namespace gausssim
