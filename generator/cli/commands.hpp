#pragma once

#include "cli/options.hpp"

namespace gaussgen::cli {

/// Each returns an exit code and throws FileError, UsageError or InternalError.
int generate(const Options& options);
int evaluate(const Options& options);
int linearize(const Options& options);
int derive(const Options& options);
int explain(const Options& options);
int init(const Options& options);
int schema();
int completion(const Options& options);
int manual();

}  // namespace gaussgen::cli
