#include "cli/option_rows.hpp"

#include <algorithm>

#include "cli/command_line.hpp"

namespace gaussgen::cli {

namespace {

std::string on_one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

OptionRow row_of(const CLI::Option& option, const CommandLine& line) {
  OptionRow row;
  if (!option.get_snames().empty()) row.short_name = "-" + option.get_snames().front();
  if (!option.get_lnames().empty()) row.long_name = "--" + option.get_lnames().front();
  row.about = on_one_line(option.get_description());
  const bool has_value = option.get_items_expected_max() > 0;
  if (!has_value) return row;
  row.value = option.get_type_name();
  row.is_list = line.lists.count(&option) > 0;
  row.argument = Argument::text;
  if (const auto found = line.arguments.find(&option); found != line.arguments.end()) row.argument = found->second;
  if (const auto found = line.choices.find(&option); found != line.choices.end()) row.choices = found->second;
  return row;
}

CommandRow row_of(const CLI::App& app, const CommandLine& line) {
  CommandRow row;
  if (app.get_parent() != nullptr) row.name = app.get_name();
  row.about = on_one_line(app.get_description());
  for (const CLI::Option* option : app.get_options()) row.options.push_back(row_of(*option, line));
  return row;
}

}  // namespace

std::vector<CommandRow> command_rows() {
  Options ignored;
  const CommandLine line(ignored);
  std::vector<CommandRow> rows{row_of(line.app, line)};
  for (const CLI::App* command : line.app.get_subcommands([](const CLI::App*) { return true; })) {
    rows.push_back(row_of(*command, line));
  }
  return rows;
}

}  // namespace gaussgen::cli
