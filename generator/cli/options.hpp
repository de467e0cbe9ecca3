#pragma once
// The command line of gauss-gen.

#include <optional>
#include <string>
#include <vector>

#include "pipeline.hpp"

namespace gaussgen::cli {

enum class Command { generate, evaluate, derivation };
enum class Format { table, json, markdown, latex };

struct Options {
  Command command = Command::generate;
  std::string model;
  PipelineOptions pipeline;

  // generate
  std::string output;  ///< folder, "-" for standard output; empty: the working folder
  std::string depfile;
  std::vector<std::string> dumps;  ///< stages
  bool check = false;
  bool list_outputs = false;
  bool timings = false;

  // evaluate, derivation
  std::vector<std::string> overrides;
  std::string time = "0";
  int digits = 17;
  Format format = Format::table;
};

/// Nothing when the program has said all there is to say (--help, --version); then `exit_code` is what to end with.
std::optional<Options> parse_options(int argc, const char* const* argv, int& exit_code);

}  // namespace gaussgen::cli
