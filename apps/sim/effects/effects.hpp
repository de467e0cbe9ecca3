#pragma once
// `gauss-sim effects`.

#include <optional>

#include "sim/run/run.hpp"

namespace gausssim {

/// `output`: path to which .json and .svg are added, and .html.
struct EffectsOptions : RunOptions {
  std::optional<double> need;  ///< largest change of the motion, relative to the range of each output
  bool writes_page = false;    ///< HTML
};

/// Returns an exit code. Throws as `run`.
int effects(const EffectsOptions& options);

}  // namespace gausssim
