#pragma once
// `gauss-sim ensemble`.

#include <optional>
#include <string>

#include "sim/run/run.hpp"

namespace gausssim {

struct EnsembleOptions : RunOptions {
  int threads = 0;  ///< 0: as many as there are processors
  std::string lanes = "auto";
  std::optional<long> trajectories;
  std::optional<long> seed;
  bool records_samples = false;
};

/// Returns an exit code. Throws cli::FileError and cli::UsageError.
int ensemble(const EnsembleOptions& options);

}  // namespace gausssim
