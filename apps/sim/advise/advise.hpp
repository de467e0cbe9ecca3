#pragma once
// `gauss-sim advise`.

#include <string>

#include "cli/messages.hpp"
#include "sim/run/found_setting.hpp"

namespace gausssim {

struct AdviseOptions {
  std::string file;
  double error = 0;
  double budget = Wanted().budget;
  std::string study;  ///< JSON of a study that has the problem; empty: a quick one is made now
  std::string format = "text";
  gaussgen::cli::MessageOptions messages;
};

/// Returns an exit code. Throws cli::FileError and cli::UsageError.
int advise(const AdviseOptions& options);

}  // namespace gausssim
