#pragma once

namespace gaussgen::cli {

/// Stable: scripts and build systems rely on them.
enum ExitCode {
  k_ok = 0,
  k_model_error = 1,
  k_usage_error = 2,
  k_file_error = 3,
  k_too_large = 4,
  k_internal_error = 70,
};

}  // namespace gaussgen::cli
