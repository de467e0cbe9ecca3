#pragma once

namespace gaussgen::cli {

/// Stable: scripts and build systems rely on them.
enum ExitCode {
  k_ok = 0,
  k_model_error = 1,
  k_usage_error = 2,
  k_file_error = 3,
  k_too_large = 4,
  k_motion_stopped = 5,  ///< of gauss-sim: what there was to that time is written
  k_not_delivered = 6,   ///< of gauss-sim: nothing that it can do has as small an error as is asked for
  k_internal_error = 70,
  k_interrupted = 130,  ///< of gauss-sim: by SIGINT or SIGTERM, as shells have it
};

struct ExitMeaning {
  ExitCode code;
  const char* meaning;
};

inline constexpr ExitMeaning k_exit_meanings[] = {{k_ok, "ok"},
                                                  {k_model_error, "error in the model"},
                                                  {k_usage_error, "usage"},
                                                  {k_file_error, "input or output"},
                                                  {k_too_large, "too large"},
                                                  {k_internal_error, "internal error"}};

}  // namespace gaussgen::cli
