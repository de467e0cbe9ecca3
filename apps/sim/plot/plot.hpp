#pragma once
// `gauss-sim plot`.

#include <string>
#include <vector>

#include "cli/messages.hpp"

namespace gausssim {

struct PlotOptions {
  std::string file;
  std::string output;                ///< SVG; empty: beside the table
  std::vector<std::string> columns;  ///< empty: all
  std::string against;               ///< empty: the first column
  gaussgen::cli::MessageOptions messages;
};

/// Returns an exit code. Throws cli::FileError and cli::UsageError.
int draw_plot(const PlotOptions& options);

}  // namespace gausssim
