#pragma once

#include "cli/options.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::cli {

/// Each returns an exit code and throws FileError, UsageError or InternalError.
int generate(const Options& options);
int evaluate(const Options& options);
int derive(const Options& options);

/// Prints what was found and returns the exit code that goes with it.
int report(const support::Diagnostics& diagnostics, const support::Source& source);

}  // namespace gaussgen::cli
