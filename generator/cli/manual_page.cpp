#include "cli/manual_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "version.hpp"

namespace gaussgen::cli {

namespace {

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

std::string synopsis_of(const std::string& program, const CommandRow& command) {
  std::string text =
      bold(program) + (command.name.empty() ? "" : " " + bold(command.name)) + " [" + italic("OPTIONS") + "]";
  for (const OptionRow& option : command.options) {
    if (option.long_name.empty() && option.short_name.empty()) text += " " + italic(option.value);
  }
  return text + "\n";
}

}  // namespace

std::string manual_page(const Manual& manual, const std::vector<CommandRow>& commands) {
  std::string name = shown(manual.program);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  std::string text = fmt::format(".TH {} 1 \"\" \"{} {}\"\n", name, shown(manual.program), shown(k_version));
  text += ".SH NAME\n" + shown(manual.program) + " \\- " + shown(manual.summary) + "\n.SH SYNOPSIS\n";
  for (const CommandRow& command : commands)
    text += (command.name.empty() ? "" : ".br\n") + synopsis_of(manual.program, command);
  text += ".SH DESCRIPTION\n" + shown(manual.description) + "\n.SH OPTIONS\n" + options_text(commands.front());
  text += ".SH COMMANDS\n";
  for (const CommandRow& command : commands) {
    if (command.name.empty()) continue;
    text += ".SS " + shown(command.name) + "\n" + shown(command.about) + "\n" + options_text(command);
  }
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : manual.exits) text += fmt::format(".TP\n{}\n{}\n", code, shown(meaning));
  text +=
      ".SH ENVIRONMENT\n.TP\n" + bold("NO_COLOR") + "\nif set to anything but an empty text, messages have no colour\n";
  text += ".TP\n" + bold("TERM") + "\nwith dumb, or without it, messages have no colour\n";
  text += ".SH EXAMPLES\n";
  for (const Manual::Example& example : manual.examples)
    text += fmt::format(".TP\n{}\n{}\n", bold(example.command), shown(example.about));
  return text + ".SH SEE ALSO\n" + shown(manual.see_also) + "\n";
}

}  // namespace gaussgen::cli
