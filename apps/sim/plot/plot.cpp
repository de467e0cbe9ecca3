#include "sim/plot/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "cli/usage_error.hpp"
#include "sim/plot/chart.hpp"
#include "sim/plot/table.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using plot::TableColumn;

/// `reactions` stands for all that begin with `reactions.`, as in a scene.
bool is_in(const std::string& name, const std::string& group) {
  if (name.compare(0, group.size(), group) != 0) return false;
  return name.size() == group.size() || name[group.size()] == '.' || name[group.size()] == '[';
}

std::vector<const TableColumn*> named(const std::vector<TableColumn>& table, const std::string& name,
                                      const char* option) {
  std::vector<const TableColumn*> found;
  std::vector<std::string> names;
  for (const TableColumn& column : table) {
    names.push_back(column.name);
    if (is_in(column.name, name)) found.push_back(&column);
  }
  if (!found.empty()) return found;
  const std::string near = gaussgen::support::did_you_mean(name, names);
  throw cli::UsageError(fmt::format("{}: the table has no column '{}'; {}", option, name,
                                    near.empty() ? "there are " + gaussgen::support::joined(names) : near));
}

std::vector<const TableColumn*> chosen(const std::vector<TableColumn>& table, const PlotOptions& options,
                                       const TableColumn& across) {
  std::vector<const TableColumn*> result;
  const auto take = [&](const TableColumn* column) {
    if (std::find(result.begin(), result.end(), column) == result.end()) result.push_back(column);
  };
  for (const std::string& name : options.columns) {
    for (const TableColumn* const column : named(table, name, "--columns")) take(column);
  }
  if (!options.columns.empty()) return result;
  // Nobody has asked for time as a line.
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (&table[i] != &across) take(&table[i]);
  }
  return result;
}

void check_numbers(const TableColumn& column) {
  if (!column.no_number.empty()) throw cli::FileError(column.no_number);
}

}  // namespace

int draw_plot(const PlotOptions& options) {
  const std::vector<TableColumn> table = plot::read_table(options.file);
  const TableColumn& across =
      options.against.empty() ? table.front() : *named(table, options.against, "--against").front();
  const std::vector<const TableColumn*> columns = chosen(table, options, across);
  if (columns.empty()) throw cli::UsageError("the table has one column, and nothing to show against it");
  check_numbers(across);
  for (const TableColumn* const column : columns) check_numbers(*column);
  const std::filesystem::path path(options.file);
  const std::string text = plot::chart(across, columns, path.stem().string());
  const std::string output =
      options.output.empty() ? std::filesystem::path(path).replace_extension(".svg").string() : options.output;
  if (output == "-") {
    cli::write_standard_output(text);
    return cli::k_ok;
  }
  if (cli::are_same_file(output, options.file))
    throw cli::UsageError(fmt::format("'{}' is the table itself; -o names another file", output));
  cli::Replacement(output, text).commit();
  cli::write_standard_output(fmt::format("wrote {}\n", output));
  return cli::k_ok;
}

}  // namespace gausssim
