#pragma once
// What is said on standard error: for people, or a line of JSON each for programs.

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/usage_error.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::cli {

enum class MessageFormat { text, json };
enum class UseOfColour { on_terminals, always, never };

struct MessageOptions {
  std::string program = "gauss-gen";
  MessageFormat format = MessageFormat::text;
  UseOfColour colour = UseOfColour::on_terminals;
  bool is_silent = false;  ///< nothing is said: of what is tried, and may not be possible
};

/// A word on the command line may be wrong before options are known; how to say so stands in it, too.
MessageOptions messages_of(int argc, const char* const* argv, const std::string& program = "gauss-gen");

/// Prints what was found and returns the exit code that goes with it.
int report(const support::Diagnostics& diagnostics, const support::Source& source, const MessageOptions& options);

/// A warning without a place in the model.
void warn(const std::string& text, const MessageOptions& options);

/// A remark, neither error nor warning.
void remark(const std::string& text, const MessageOptions& options);

/// What a remark says, for programs: members of its JSON object beside the text.
using Facts = std::vector<std::pair<std::string, std::variant<std::string, long long, double>>>;

void remark(const std::string& text, const Facts& facts, const MessageOptions& options);

/// Why the program ends: not because of something in the text of a model. Returns `code`.
int fail(const std::string& what, int code, const MessageOptions& options, const std::string& hint = {});

/// Likewise, because of the command line.
int fail(const UsageError& error, const MessageOptions& options);

}  // namespace gaussgen::cli
