#pragma once
// The options of gauss-gen as rows, for pages and scripts that are written from them.

#include <string>
#include <vector>

#include "cli/command_line.hpp"

namespace gaussgen::cli {

struct OptionRow {
  std::string short_name;  ///< "-o", or empty
  std::string long_name;   ///< "--output"; empty: an argument at its place
  std::string value;       ///< "DIR"; empty: none follows
  std::string about;       ///< one line
  std::vector<std::string> choices;
  bool is_list = false;  ///< several choices with commas between
  Argument argument = Argument::none;
};

struct CommandRow {
  std::string name;   ///< empty: the program itself
  std::string about;  ///< one line
  std::vector<OptionRow> options;
};

/// The program first, then its commands as --help lists them.
std::vector<CommandRow> command_rows();

/// Its first sentence.
std::string summary_of(const CommandRow& command);

}  // namespace gaussgen::cli
