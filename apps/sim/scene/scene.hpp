#pragma once
// What is to be simulated: a model, from where, how long, and what is wanted of it. docs/scenes.md.

#include <optional>
#include <string>
#include <vector>

#include "model/ast.hpp"
#include "model/given_counts.hpp"
#include "sim/scene/ensemble.hpp"
#include "support/source.hpp"

namespace gausssim {

/// A value that takes the place of one in the model's file.
struct Given {
  std::string name;
  gaussgen::model::Ast value;
  gaussgen::support::Span span;  ///< of the name
};

/// A word of a list, such as an output.
struct Word {
  std::string text;
  gaussgen::support::Span span;
};

struct Scene {
  std::string name, about;
  Word model;  ///< file, beside that of the scene
  gaussgen::model::GivenCounts counts;
  std::vector<Given> parameters, initial, inputs;
  std::optional<gaussgen::model::Ast> start, duration, every;  ///< over parameters
  std::optional<long> samples;                                 ///< the start and the end among them
  std::vector<Word> outputs;                                   ///< empty: those that everybody wants
  std::optional<Word> method, number, projection, strategy, engine;
  std::optional<double> tolerance, error, step;
  std::optional<Ensemble> ensemble;
};

}  // namespace gausssim
