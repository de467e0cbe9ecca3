#pragma once
// `gauss-sim advise`.

#include <string>

#include "sim/run/run.hpp"

namespace gausssim {

/// With an error.
struct AdviseOptions : RunOptions {
  std::string study;  ///< JSON of a study that has the problem; empty: a quick one is made now
  std::string format = "text";
};

/// Returns an exit code. Throws cli::FileError and cli::UsageError.
int advise(const AdviseOptions& options);

}  // namespace gausssim
