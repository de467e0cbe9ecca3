#pragma once
// What is generated: a model, or that of a scene with what the scene chooses.

#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "support/source.hpp"

namespace gaussgen::cli {

struct Input {
  Options options;  ///< with what a scene says; `model` is that of the scene then
  support::Source source;
  std::optional<support::Source> scene = std::nullopt;
  std::vector<support::Span> places = {};  ///< of the effects' words in it; empty where options choose
};

/// Nothing where the scene has mistakes: they are reported, and `code` is the exit code. Throws FileError.
std::optional<Input> read_input(const Options& options, int& code);

}  // namespace gaussgen::cli
