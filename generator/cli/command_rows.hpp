#pragma once
// The options of a program and of its commands as rows, for pages and scripts that are written from them.

#include <string>
#include <vector>

namespace gaussgen::cli {

/// What may stand after an option or at a place, for shells.
enum class Argument { none, text, file, folder, model };

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

/// Its first sentence.
std::string summary_of(const CommandRow& command);

}  // namespace gaussgen::cli
