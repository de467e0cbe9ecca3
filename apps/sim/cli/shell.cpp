#include "sim/cli/shell.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/completion_scripts.hpp"
#include "cli/exit_codes.hpp"
#include "cli/manual_page.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

/// CLI11 writes a type with the words that are taken: `NAME:{auto,taylor}`.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  std::vector<std::string> choices;
  std::istringstream words(type.substr(open + 1, close - open - 1));
  for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  return choices;
}

cli::Argument argument_of(const std::string& value) {
  if (value == "FILE") return cli::Argument::model;
  const bool is_file = value == "CSV" || value == "SVG" || value == "PATH";
  return is_file ? cli::Argument::file : cli::Argument::text;
}

cli::OptionRow row_of(const CLI::Option& option) {
  cli::OptionRow row;
  if (!option.get_snames().empty()) row.short_name = "-" + option.get_snames().front();
  if (!option.get_lnames().empty()) row.long_name = "--" + option.get_lnames().front();
  row.about = option.get_description();
  if (option.get_items_expected_max() == 0) return row;
  const std::string type = option.get_type_name();
  const bool is_named = !row.short_name.empty() || !row.long_name.empty();
  row.value = is_named ? type.substr(0, type.find_first_of(":{ ")) : option.get_name(true);
  row.choices = choices_in(type);
  row.is_list = option.get_delimiter() == ',' && !row.choices.empty();
  row.argument = argument_of(row.value);
  return row;
}

cli::CommandRow row_of(const CLI::App& app) {
  cli::CommandRow row;
  if (app.get_parent() != nullptr) row.name = app.get_name();
  row.about = app.get_description();
  for (const CLI::Option* const option : app.get_options()) row.options.push_back(row_of(*option));
  return row;
}

std::vector<cli::CommandRow> rows_of(const CLI::App& app) {
  std::vector<cli::CommandRow> rows{row_of(app)};
  rows.front().options.emplace_back().value = "COMMAND";
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; }))
    rows.push_back(row_of(*command));
  return rows;
}

cli::Manual texts() {
  cli::Manual manual;
  manual.program = "gauss-sim";
  manual.summary = "simulates mechanical models";
  manual.description =
      "Reads a mechanical model in YAML, or a scene that says from where, how long and how it is simulated, compiles "
      "its "
      "equations of motion and integrates them. A motion becomes a table and a summary; a study shows what accuracy "
      "costs "
      "in time, by each method.";
  manual.exits = {{cli::k_ok, "ok"},
                  {cli::k_model_error, "error in the model or the scene"},
                  {cli::k_usage_error, "usage"},
                  {cli::k_file_error, "input or output"},
                  {cli::k_too_large, "too large"},
                  {cli::k_motion_stopped, "the motion stops before its end; what there is of it is written"},
                  {cli::k_internal_error, "internal error"},
                  {130, "interrupted; run --resume goes on"}};
  manual.examples = {
      {"gauss-sim run pendulum.yaml --duration 20", "writes pendulum.csv and pendulum.json"},
      {"gauss-sim run pendulum.yaml --set theta=3 --method rk4 --step 1e-3", "from elsewhere, in other steps"},
      {"gauss-sim run long.yaml --resume", "goes on where Ctrl-C ended it"},
      {"gauss-sim plot pendulum.csv --columns theta,energy", "writes pendulum.svg"},
      {"gauss-sim study pendulum.yaml", "all methods, their errors and their times"}};
  manual.see_also = "gauss-gen(1), gauss-sim.md and scenes.md in the folder doc/gauss";
  return manual;
}

}  // namespace

std::string manual_of(const CLI::App& app) { return cli::manual_page(texts(), rows_of(app)); }

std::string completion_of(const CLI::App& app, const std::string& shell) {
  return cli::completion_script(shell, "gauss-sim", rows_of(app));
}

}  // namespace gausssim
