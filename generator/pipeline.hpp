#pragma once
// The whole compiler: model text in, C++ header out, a dump after every stage.

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "emit/header.hpp"
#include "emit/unit.hpp"
#include "mechanics.hpp"
#include "model/choices.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

enum class Route {
  emitted,  ///< theory section 4 on the graph
  paper,    ///< Z, Γ, э, c, b^{μi} in GiNaC, lowered
};

struct PipelineOptions {
  model::Choices choices;  ///< counts in place of those of the model, and which of its effects act
  std::function<void(model::Model&)> adjust =
      nullptr;                       ///< what is changed in it when it is read: values of parameters and of the start
  std::vector<std::string> outputs;  ///< empty: those of the model; if it names none, all
  std::vector<std::string> where_possible;  ///< outputs beside them, without a word where a model has none
  std::vector<std::string> sensitivities;   ///< parameters; empty: those of the model
  bool fold = false;
  bool plain = false;                   ///< nothing is rewritten to take fewer operations
  std::vector<std::string> as_written;  ///< rules against cancellation that are left out, of `rules_for_digits`
  bool assemble = false;                ///< constraints may move given initial values
  Route route = Route::emitted;
  Strategy strategy = Strategy::automatic;
  std::string name;  ///< of the header; empty: that of the model
  std::string
      chosen_by;  ///< a scene, or a file with options: what chose effects, counts and values; empty: `choices` say all
  std::string name_space;                         ///< empty: gauss::<model name>
  int part_operations = emit::k_part_operations;  ///< of a function above twice as many
  std::vector<std::string> compiled_for;          ///< scalar types of a source file of its own; empty: none
  std::size_t most_nodes = ir::k_most_nodes;
  bool only_check = false;        ///< what is wrong with the model is all that is wanted: no output is formed
  bool leaves_start_out = false;  ///< as was found: the motion starts in another regime than the one of `choices`
  std::string last_stage;         ///< after which nothing is asked for; empty: the last one
};

/// One stage as `--timings` shows it. Nodes are those of the graph: what one stage has made, the next one finds there.
struct StageTime {
  std::string stage;
  double milliseconds = 0;
  std::size_t nodes_in = 0;
  std::size_t nodes_out = 0;
  std::size_t bytes = 0;  ///< of text that it reads or writes; 0: none
};

/// Called after each stage with its name and a way to print its result.
using StageObserver = std::function<void(const std::string& stage, const std::function<std::string()>& dump)>;

struct PipelineResult {
  std::string model_name;
  std::vector<std::string> effects;  ///< that act
  bool has_units = false;            ///< of the model: whether dimensions were checked
  std::string mobility;              ///< in words; may be empty
  std::string header;
  emit::cpp::File tree;                ///< of the header
  emit::Unit unit;                     ///< names, units and shapes of what is in it
  std::string source;                  ///< that compiles the header's functions; empty unless asked for
  std::vector<std::string> assembled;  ///< initial values that the constraints moved, in words
  std::vector<StageTime> times;
  std::vector<emit::PassEffects> passes;  ///< what each pass saved, function by function
  std::vector<emit::OutputSize> outputs;  ///< what is in the header
  bool chose_outputs = false;             ///< whether the model or the options name them
};

/// Nothing when the model has errors; they are in `diagnostics`. Throws ir::TooManyNodes, which says
/// in which stage.
std::optional<PipelineResult> compile(support::Source& source, const PipelineOptions& options,
                                      support::Diagnostics& diagnostics, const StageObserver& observe);

/// Names of the rules that put sums and products into forms that keep their digits.
std::vector<std::string> rules_for_digits();

/// In order.
const std::vector<std::string>& stage_names();

/// Those for `--dump`: all that make something.
std::vector<std::string> stages_with_dump();

}  // namespace gaussgen
