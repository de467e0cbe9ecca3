#pragma once
// `gauss-sim run`.

#include <optional>
#include <string>
#include <vector>

#include "cli/messages.hpp"
#include "sim/run/found_setting.hpp"

namespace gausssim {

struct RunOptions {
  std::string file;
  std::string instance;  ///< of a scene that has some; empty: `run` takes all of them
  std::string output;    ///< CSV; empty: <name>.csv in the working folder; "-": standard output
  std::vector<std::string> sets, counts, effects, outputs;
  std::string method, number, projection, strategy, engine, code;  ///< empty: those of the scene
  std::string start, duration, every;                              ///< expressions
  std::optional<double> tolerance, step, longest_step, error;
  std::optional<double> budget = std::nullopt;  ///< s, of the search for a setting
  std::optional<long> samples, max_steps;
  bool quiet = false;
  bool resume = false;  ///< goes on from what an interrupted run has left
  gaussgen::cli::MessageOptions messages;
};

/// Returns an exit code. `find` finds settings where an error is asked for. Throws cli::FileError and cli::UsageError, Interrupted, and OutOfTime, where there is nothing to be kept.
int run(const RunOptions& options, const FindSetting& find);

}  // namespace gausssim
