#pragma once
// `gauss-sim study`.

#include <string>
#include <vector>

#include "cli/messages.hpp"

namespace gausssim {

struct StudyOptions {
  std::vector<std::string> files;       ///< scenes or models, a problem each
  std::string instance;                 ///< of each of them; empty: they have none
  std::string output = "study";         ///< path without its ending: .json, .csv, .html
  std::vector<std::string> methods;     ///< these alone; empty: all, and all else that there is to vary
  double budget = 60;                   ///< s for each problem
  double loosest = 1e-3, tightest = 0;  ///< 0: as far as the digits go, by methods that are defaults
  bool quiet = false;
  gaussgen::cli::MessageOptions messages;
};

/// Returns an exit code. Throws cli::FileError and cli::UsageError, and Interrupted where nothing has been measured.
int study(const StudyOptions& options);

}  // namespace gausssim
