#pragma once
// The options of gauss-gen and of its commands: the one table from which the command line is read, and the page of --help,
// the manual page and the completions of shells are written.

#include <CLI/CLI.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/command_rows.hpp"
#include "cli/options.hpp"

namespace gaussgen::cli {

struct CommandLine {
  /// Reading a command line fills `options`.
  explicit CommandLine(Options& options);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  CLI::App app;
  std::map<std::string, Command> commands;
  std::map<const CLI::Option*, std::vector<std::string>> choices;  ///< words that an option takes
  std::set<const CLI::Option*> lists;                ///< of them, those that take several, with commas between
  std::map<const CLI::Option*, Argument> arguments;  ///< those of the others that are not text
};

/// Throws UsageError.
[[noreturn]] void refuse(const std::string& option, const std::string& why);

}  // namespace gaussgen::cli
