#pragma once
// What all ways of generating have in common: from a model to files that are put in place together.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/input.hpp"
#include "pipeline.hpp"

namespace gaussgen::cli {

using Files = std::vector<std::pair<std::string, std::string>>;  ///< paths and texts

/// In the folder that options name; "-" for standard output.
std::string header_path(const Options& options, const std::string& model_name);

/// All of them, and what they depend on, or none.
void write_files(const Input& input, Files files);

/// Of one header. Nothing where the model has mistakes, which are reported: `code`.
std::optional<PipelineResult> compiled(const Options& options, support::Source& source, std::string& dumped, int& code);

/// Members of Guards, in their order; none where it has none.
std::vector<std::string> guards_of(const emit::Unit& unit);

void say_checked(const PipelineResult& result, const support::Source& source);

/// A header for each set of effects or regime, and one with a table of them.
int generate_variants(Input& input);

/// Whether the scene is of several bodies, and options choose no sets for it.
bool is_of_instances(const Input& input);

/// One header with the functions of each set of effects, and a table of the bodies.
int generate_instances(Input& input);

}  // namespace gaussgen::cli
