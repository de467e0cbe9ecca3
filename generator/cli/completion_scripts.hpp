#pragma once
// Scripts with which shells complete command lines.

#include <string>
#include <vector>

#include "cli/command_rows.hpp"

namespace gaussgen::cli {

/// `shell`: bash, zsh or fish. `commands`: the program first.
std::string completion_script(const std::string& shell, const std::string& program,
                              const std::vector<CommandRow>& commands);

}  // namespace gaussgen::cli
