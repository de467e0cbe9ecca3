#include "cli/completion_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gaussgen::cli {

namespace {

/// As a name in scripts.
std::string function_of(const std::string& program) {
  std::string name = "_" + program;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string with_blanks(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::vector<std::string> names_of(const OptionRow& option) {
  std::vector<std::string> names;
  if (!option.short_name.empty()) names.push_back(option.short_name);
  if (!option.long_name.empty()) names.push_back(option.long_name);
  return names;
}

bool stands_at_its_place(const OptionRow& option) { return names_of(option).empty(); }

std::vector<std::string> command_names(const std::vector<CommandRow>& commands) {
  std::vector<std::string> names;
  for (const CommandRow& command : commands) {
    if (!command.name.empty()) names.push_back(command.name);
  }
  return names;
}

std::string escaped(const std::string& text, const std::string& signs, const std::string& before) {
  std::string result;
  for (const char c : text) result += (signs.find(c) == std::string::npos ? "" : before) + c;
  return result;
}

// --- bash

/// Words for the value of an option, or for what stands at its place.
std::string bash_words(const OptionRow& option) {
  if (option.is_list) {
    return fmt::format("COMPREPLY=($(compgen -W '{}' -P \"${{word%\"${{word##*,}}\"}}\" -- \"${{word##*,}}\"))",
                       with_blanks(option.choices));
  }
  if (!option.choices.empty()) {
    return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\"))", with_blanks(option.choices));
  }
  switch (option.argument) {
    case Argument::folder: return "compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- \"$word\")";
    case Argument::file: return "compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- \"$word\")";
    case Argument::model:
      return "compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- \"$word\"; compgen -f -X "
             "'!*.yaml' -- "
             "\"$word\")";
    default: return "COMPREPLY=()";
  }
}

std::string bash_values(const CommandRow& command) {
  std::string text;
  for (const OptionRow& option : command.options) {
    if (stands_at_its_place(option) || option.value.empty()) continue;
    std::string patterns;
    for (const std::string& name : names_of(option)) {
      patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : " | ", command.name, name);
    }
    text += fmt::format("    {}) {}; return ;;\n", patterns, bash_words(option));
  }
  return text;
}

std::string bash_options(const CommandRow& command) {
  std::vector<std::string> names;
  for (const OptionRow& option : command.options) {
    for (const std::string& name : names_of(option)) names.push_back(name);
  }
  return fmt::format("    '{}') COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", command.name, with_blanks(names));
}

std::string bash_places(const CommandRow& command, const std::vector<CommandRow>& commands) {
  std::string text = fmt::format("    '{}')", command.name);
  for (const OptionRow& option : command.options) {
    if (stands_at_its_place(option)) text += " " + bash_words(option);
  }
  if (command.name.empty()) {
    text += fmt::format("; COMPREPLY+=($(compgen -W '{}' -- \"$word\"))", with_blanks(command_names(commands)));
  }
  return text + " ;;\n";
}

std::string for_bash(const std::string& program, const std::vector<CommandRow>& commands) {
  std::string alternatives;
  for (const std::string& name : command_names(commands)) alternatives += (alternatives.empty() ? "" : " | ") + name;
  std::string text = fmt::format("# bash completion of {0}, written by `{0} completion bash`.\n{1}() {{\n", program,
                                 function_of(program)) +
                     "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i\n"
                     "  # --option=value comes as three words.\n"
                     "  if [[ $word == '=' ]]; then word=''; fi\n"
                     "  if [[ $before == '=' ]]; then before=${COMP_WORDS[COMP_CWORD - 2]}; fi\n"
                     "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
                     "    case ${COMP_WORDS[i]} in\n      " +
                     alternatives +
                     ") command=${COMP_WORDS[i]}; break ;;\n    esac\n  done\n"
                     "  # shellcheck disable=SC2207  # the words have no blanks\n"
                     "  case \"$command $before\" in\n";
  for (const CommandRow& command : commands) text += bash_values(command);
  text += "  esac\n  if [[ $word == -* ]]; then\n    case $command in\n";
  for (const CommandRow& command : commands) text += "  " + bash_options(command);
  text += "    esac\n    return\n  fi\n  case $command in\n";
  for (const CommandRow& command : commands) text += bash_places(command, commands);
  return text + fmt::format("  esac\n}}\ncomplete -F {} {}\n", function_of(program), program);
}

// --- zsh

std::string zsh_action(const OptionRow& option) {
  if (option.is_list) return "_values -s , word " + with_blanks(option.choices);
  if (!option.choices.empty()) return "(" + with_blanks(option.choices) + ")";
  switch (option.argument) {
    case Argument::folder: return "_files -/";
    case Argument::file: return "_files";
    case Argument::model: return "_files -g \"*.yaml\"";
    default: return "";
  }
}

std::string zsh_about(const std::string& text) { return escaped(escaped(text, "[]:\\", "\\"), "'", "'\\'"); }

std::string zsh_option(const OptionRow& option) {
  const bool has_value = !option.value.empty();
  const std::string value = has_value ? fmt::format(":{}:{}", zsh_about(option.value), zsh_action(option)) : "";
  std::string text;
  for (const std::string& name : names_of(option)) {
    const char* const tie = !has_value ? "" : name == option.long_name ? "=" : "+";
    text += fmt::format("        '{}{}[{}]{}' \\\n", name, tie, zsh_about(option.about), value);
  }
  return text;
}

std::string zsh_command(const std::string& function, const CommandRow& command) {
  std::string text;
  for (const OptionRow& option : command.options) {
    text += stands_at_its_place(option) ? fmt::format("        '1:{}:{}' \\\n", escaped(option.value, "[]", "\\"),
                                                      command.name.empty() ? function + "_first" : zsh_action(option))
                                        : zsh_option(option);
  }
  return text;
}

std::string for_zsh(const std::string& program, const std::vector<CommandRow>& commands) {
  const std::string function = function_of(program);
  std::string text = fmt::format(
      "#compdef {0}\n# zsh completion of {0}, written by `{0} completion zsh`.\n{1}_first() {{\n"
      "  local -a commands=(\n",
      program, function);
  for (const CommandRow& command : commands) {
    if (!command.name.empty()) text += fmt::format("    '{}:{}'\n", command.name, zsh_about(summary_of(command)));
  }
  text += "  )\n  _describe command commands\n  _files -g \"*.yaml\"\n}\n" + function + "() {\n  case ${words[2]} in\n";
  for (const CommandRow& command : commands) {
    if (command.name.empty()) continue;
    text += fmt::format(
        "    {})\n      shift words\n      (( CURRENT-- ))\n      _arguments \\\n{}        && return\n      ;;\n",
        command.name, zsh_command(function, command));
  }
  text += fmt::format("    *)\n      _arguments \\\n{}        && return\n      ;;\n",
                      zsh_command(function, commands.front()));
  return text + "  esac\n}\n" + function + " \"$@\"\n";
}

// --- fish

std::string fish_words(const OptionRow& option) {
  if (!option.choices.empty()) return fmt::format(" -x -a '{}'", with_blanks(option.choices));
  switch (option.argument) {
    case Argument::none: return "";
    case Argument::folder: return " -x -a '(__fish_complete_directories)'";
    case Argument::file: return " -r -F";
    case Argument::model: return " -k -a '(__fish_complete_suffix .yaml)'";
    default: return " -x";
  }
}

std::string fish_option(const std::string& program, const OptionRow& option, const std::string& condition) {
  if (stands_at_its_place(option) && option.argument == Argument::none) return "";
  std::string text = fmt::format("complete -c {} -n '{}'", program, condition);
  if (!option.short_name.empty()) text += " -s " + option.short_name.substr(1);
  if (!option.long_name.empty()) text += " -l " + option.long_name.substr(2);
  text += fish_words(option);
  return text + (option.about.empty() ? "" : fmt::format(" -d '{}'", escaped(option.about, "'\\", "\\"))) + "\n";
}

std::string for_fish(const std::string& program, const std::vector<CommandRow>& commands) {
  std::string text =
      fmt::format("# fish completion of {0}, written by `{0} completion fish`.\ncomplete -c {0} -f\n", program);
  const std::string seen = "__fish_seen_subcommand_from ";
  for (const CommandRow& command : commands) {
    const std::string condition =
        command.name.empty() ? "not " + seen + with_blanks(command_names(commands)) : seen + command.name;
    if (!command.name.empty()) {
      text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d '{}'\n", program, command.name,
                          escaped(summary_of(command), "'\\", "\\"));
    }
    for (const OptionRow& option : command.options) text += fish_option(program, option, condition);
  }
  return text;
}

}  // namespace

std::string summary_of(const CommandRow& command) {
  const std::size_t end = std::min({command.about.find(". "), command.about.find(": "), command.about.size()});
  const std::string summary = command.about.substr(0, end);
  return !summary.empty() && summary.back() == '.' ? summary.substr(0, summary.size() - 1) : summary;
}

std::string completion_script(const std::string& shell, const std::string& program,
                              const std::vector<CommandRow>& commands) {
  const auto write = shell == "bash" ? for_bash : shell == "zsh" ? for_zsh : for_fish;
  return write(program, commands);
}

}  // namespace gaussgen::cli
