#pragma once
// What is to be simulated: a model, from where, how long, and what is wanted of it. docs/scenes.md.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/ast.hpp"
#include "sim/scene/ensemble.hpp"
#include "support/source.hpp"

namespace gausssim {

/// Whether it is of the command line, and has no place in a file.
inline bool is_of_option(const gaussgen::support::Span& place) { return place.end == 0; }

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

/// A count that takes the place of one in the model's file.
struct GivenCount {
  Word name;
  std::int64_t count = 1;
};

/// Another description of the same motion: what is not said is as in the scene.
struct GivenForm {
  Word name;
  std::optional<Word> model, strategy;
  std::vector<Given> parameters,
      initial;  ///< beside those of the scene, if the model is the same; else instead of them
};

/// One of several bodies of the scene's model. What it does not say is as in the scene.
struct Instance {
  Word name;
  gaussgen::support::Span extent;  ///< of all that it says
  std::string about;
  std::vector<Word> effects;  ///< on top of those of the scene (gaussgen::choice_of_instance)
  std::vector<Given> parameters, initial, inputs, exact;
  std::vector<Word> outputs;
  std::optional<Word> method;
  std::optional<double> tolerance, step, longest_step;
  std::map<std::string, gaussgen::support::Span> places;  ///< of the values of these numbers
};

struct Scene {
  std::string name, about;
  Word model;                     ///< file, beside that of the scene
  std::string form = "as given";  ///< what its own description is called beside others
  std::vector<GivenForm> forms;
  std::vector<GivenCount> counts;
  std::vector<Word> effects;  ///< which act, in the words of model::GivenEffects; empty: the default
  std::vector<Given> parameters, initial, inputs;
  std::vector<Given> exact;  ///< outputs that are known as functions of time and parameters
  std::optional<gaussgen::model::Ast> start, duration, every;  ///< over parameters
  std::optional<long> samples;                                 ///< the start and the end among them
  std::vector<Word> outputs;                                   ///< empty: those that everybody wants
  std::optional<Word> method, number, projection, strategy, engine, code;
  std::optional<double> tolerance, error, step, longest_step, gain;
  std::map<std::string, gaussgen::support::Span> places;  ///< of the values of these numbers; options have none
  std::optional<Ensemble> ensemble;
  std::vector<Instance> instances;          ///< each moves by itself; none: the scene is one motion
  gaussgen::support::Span instances_place;  ///< of the key
  std::string instance;                     ///< which of them this scene has become; empty: none
};

/// Whether the scene leaves it to us.
inline bool chooses_method(const Scene& scene) { return !scene.method || scene.method->text == "auto"; }

}  // namespace gausssim
