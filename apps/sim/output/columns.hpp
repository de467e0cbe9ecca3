#pragma once
// What a run writes: numbers at each sample, by the names that users know.

#include <functional>
#include <string>
#include <vector>

#include "sim/drive/motion_model.hpp"
#include "sim/engine/binding.hpp"
#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

struct Column {
  std::string name, unit, about;
  bool is_state = false;      ///< else of a function
  std::size_t source = 0;     ///< component of the state, or which of the functions
  std::size_t slot = 0;       ///< of what the function fills; of rates, of the derivative
  bool is_conserved = false;  ///< the same in every motion of the model
};

/// A function that has to be called at each sample.
struct SampledFunction {
  std::string function;  ///< rhs, reactions, energy, …
  std::size_t size = 0;  ///< numbers that it fills
};

struct Columns {
  std::vector<Column> columns;
  std::vector<SampledFunction> functions;
};

std::vector<std::string> names_of(const std::vector<SampledFunction>& functions);

/// Outputs of the generator that depend on the state alone, and so can be sampled.
const std::vector<std::string>& sampled_outputs();

/// What can be asked for: groups first, then single numbers.
std::vector<std::string> output_names(const Described& model);

/// The model with all that could be asked for, also what this run leaves out; asked only where a name is unknown.
using ListEverything = std::function<Described()>;

/// `wanted`, or what everybody wants: coordinates, speeds, and the energy where the model has one. Reports unknown names.
Columns choose_columns(const Described& model, const std::vector<Word>& wanted,
                       gaussgen::support::Diagnostics& diagnostics, const ListEverything& list = nullptr);

/// The outputs of the generator that names of outputs need, known before it runs; what is no output of it is left out.
std::vector<std::string> generator_outputs(const std::vector<Word>& wanted);

}  // namespace gausssim
