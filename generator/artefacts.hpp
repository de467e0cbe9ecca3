#pragma once
// The functions of an emitted header, one builder each.

#include <string>
#include <vector>

#include "emit/unit.hpp"
#include "mechanics.hpp"

namespace gaussgen {

/// What `--outputs` and the model's `outputs:` may name, in the order of the header.
struct OutputKind {
  std::string name;
  std::string about;
  bool is_usual = true;  ///< emitted where nothing is said of outputs
};

const std::vector<OutputKind>& output_kinds();

/// The artefact called `name`; nothing when the model has none (no reactions, compulsion of a massless body).
std::vector<emit::Artefact> build_artefact(const std::string& name, Mechanics& mechanics);

/// Whether `build_artefact` makes anything: found without forming it.
bool has_output(const std::string& name, Mechanics& mechanics);

/// Of Model::inputs, those that inverse dynamics finds.
std::vector<std::size_t> sought_inputs(const model::Model& model);

}  // namespace gaussgen
