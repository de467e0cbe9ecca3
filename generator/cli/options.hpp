#pragma once
// The command line of gauss-gen.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/messages.hpp"
#include "linearisation.hpp"
#include "pipeline.hpp"

namespace gaussgen::cli {

enum class Command { generate, evaluate, linearize, derivation, explain, init, schema, completion };
enum class Format { table, json, markdown, latex, text };

struct Options {
  Command command = Command::generate;
  std::string model;
  MessageOptions messages;
  PipelineOptions pipeline;

  // generate
  std::string output;              ///< folder, "-" for standard output; empty: the working folder
  std::vector<std::string> split;  ///< types of a source file of its own
  /// By name, a header each: words of effects, and modes of a regime as floor=closed.
  std::vector<std::pair<std::string, std::vector<std::string>>> variants;
  std::string instance;  ///< of a scene that has some; empty: all of them
  std::string depfile;
  std::string depfile_target;      ///< empty: the header
  std::vector<std::string> dumps;  ///< stages
  int most_seconds = 0;            ///< of processor time for the derivation; 0: any
  bool check = false;
  bool list_outputs = false;
  bool timings = false;
  bool man = false;

  // evaluate, derivation
  std::vector<std::string> overrides;
  std::vector<std::string> accelerations;  ///< NAME=VALUE
  bool at_equilibrium = false;
  std::string time = "0";
  int digits = 17;
  Format format = Format::table;

  // linearize
  LinearisedAt linearised_at = LinearisedAt::initial;
  int linear_digits = 0;  ///< 0: some in a table, all that there are in JSON

  std::string word;  ///< explain: a code; init: a name; completion: a shell
};

/// Those that `completion` writes for.
const std::vector<std::string>& shells();

/// Nothing when the program has said all there is to say (--help, --version); then `exit_code` is what to end with.
std::optional<Options> parse_options(int argc, const char* const* argv, int& exit_code);

}  // namespace gaussgen::cli
