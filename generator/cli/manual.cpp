// The manual page, in the language of troff.

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/option_rows.hpp"
#include "version.hpp"

namespace gaussgen::cli {

namespace {

struct Example {
  const char* command;
  const char* about;
};

constexpr Example k_examples[] = {
    {"gauss-gen init pendulum", "writes a model to begin with"},
    {"gauss-gen pendulum.yaml -o include", "writes include/pendulum.hpp"},
    {"gauss-gen evaluate pendulum.yaml --set theta=pi/3", "accelerations and reactions there, without a compiler"},
    {"gauss-gen evaluate crane.yaml --equilibrium", "where it rests, and what its constraints carry there"},
    {"gauss-gen evaluate arm.yaml --accelerate elbow=2", "forces and inputs that make this motion"},
    {"gauss-gen linearize bicycle.yaml --set lean=0 --set steer=0", "eigenvalues and modes of the upright run"},
    {"gauss-gen explain E041", "what is wrong, with an example and its cure"},
};
constexpr const char* k_see_also = "README.md, the tutorial and the reference of the format in the folder doc/gauss";

/// Text that troff shows as it is.
std::string shown(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool begins_line = result.empty() || result.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if (c == '\'') {
      result += "\\(aq";
    } else {
      result += c;
    }
  }
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + shown(text) + "\\fR"; }

std::string italic(const std::string& text) { return "\\fI" + shown(text) + "\\fR"; }

std::string option_text(const OptionRow& option) {
  std::string names = bold(option.short_name);
  if (option.short_name.empty()) names = bold(option.long_name);
  if (!option.short_name.empty() && !option.long_name.empty()) names += ", " + bold(option.long_name);
  if (!option.value.empty()) names += " " + italic(option.value);
  return ".TP\n" + names + "\n" + shown(option.about) + "\n";
}

std::string options_text(const CommandRow& command) {
  std::string text;
  for (const OptionRow& option : command.options) {
    if (!option.long_name.empty()) text += option_text(option);
  }
  return text;
}

std::string synopsis_of(const CommandRow& command) {
  std::string text =
      bold("gauss-gen") + (command.name.empty() ? "" : " " + bold(command.name)) + " [" + italic("OPTIONS") + "]";
  for (const OptionRow& option : command.options) {
    if (option.long_name.empty() && option.short_name.empty()) text += " " + italic(option.value);
  }
  return text + "\n";
}

std::string page() {
  const std::vector<CommandRow> commands = command_rows();
  std::string text = fmt::format(".TH GAUSS\\-GEN 1 \"\" \"gauss\\-gen {}\"\n", shown(k_version));
  text += ".SH NAME\n" + shown("gauss-gen") + " \\- " + shown(k_summary) + "\n.SH SYNOPSIS\n";
  for (const CommandRow& command : commands) text += (command.name.empty() ? "" : ".br\n") + synopsis_of(command);
  text += ".SH DESCRIPTION\n" + shown(k_description) + "\n.SH OPTIONS\n" + options_text(commands.front());
  text += ".SH COMMANDS\n";
  for (const CommandRow& command : commands) {
    if (command.name.empty()) continue;
    text += ".SS " + shown(command.name) + "\n" + shown(command.about) + "\n" + options_text(command);
  }
  text += ".SH EXIT STATUS\n";
  for (const ExitMeaning& exit : k_exit_meanings)
    text += fmt::format(".TP\n{}\n{}\n", static_cast<int>(exit.code), shown(exit.meaning));
  text +=
      ".SH ENVIRONMENT\n.TP\n" + bold("NO_COLOR") + "\nif set to anything but an empty text, messages have no colour\n";
  text += ".TP\n" + bold("TERM") + "\nwith dumb, or without it, messages have no colour\n";
  text += ".SH EXAMPLES\n";
  for (const Example& example : k_examples)
    text += fmt::format(".TP\n{}\n{}\n", bold(example.command), shown(example.about));
  return text + ".SH SEE ALSO\n" + shown(k_see_also) + "\n";
}

}  // namespace

int manual() {
  write_standard_output(page());
  return k_ok;
}

}  // namespace gaussgen::cli
