#pragma once
// The manual page of a program, in the language of troff.

#include <string>
#include <utility>
#include <vector>

#include "cli/command_rows.hpp"

namespace gaussgen::cli {

/// What options and commands do not say.
struct Manual {
  struct Example {
    std::string command, about;
  };

  std::string program, summary, description;
  std::vector<std::pair<int, std::string>> exits;  ///< codes and what they mean
  std::vector<Example> examples;
  std::string see_also;
};

/// `commands`: the program first.
std::string manual_page(const Manual& manual, const std::vector<CommandRow>& commands);

}  // namespace gaussgen::cli
