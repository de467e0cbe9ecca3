#pragma once
// The options of gauss-gen as rows.

#include <vector>

#include "cli/command_rows.hpp"

namespace gaussgen::cli {

/// The program first, then its commands as --help lists them.
std::vector<CommandRow> command_rows();

}  // namespace gaussgen::cli
