#include "sim/plot/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

std::vector<const TableColumn*> named(const std::vector<TableColumn>& table, const std::string& name) {
  std::vector<const TableColumn*> found;
  for (const TableColumn& column : table) {
    if (is_in(column.name, name)) found.push_back(&column);
  }
  return found;
}

/// All that the table does not have are named at once.
void check_names(const std::vector<TableColumn>& table, const std::vector<std::string>& wanted, const char* option) {
  std::vector<std::string> names, wrong;
  for (const TableColumn& column : table) names.push_back(column.name);
  for (const std::string& name : wanted) {
    if (!named(table, name).empty()) continue;
    const std::string near = gaussgen::support::did_you_mean(name, names);
    wrong.push_back(fmt::format("'{}'{}", name, near.empty() ? "" : fmt::format(" ({})", near)));
  }
  if (wrong.empty()) return;
  throw cli::UsageError(fmt::format("{}: the table has no column {}; there are {}", option,
                                    fmt::join(wrong, ", and none "), gaussgen::support::joined(names)));
}

/// What a table of `gauss-sim ensemble` begins with.
bool is_of_ensemble(const std::vector<TableColumn>& table) {
  return table.size() > 2 && table[0].name == "trajectory" && table[1].name == "status";
}

/// Outputs come behind the time, and what varies stands before it.
std::size_t place_of_time(const std::vector<TableColumn>& table) {
  const auto time =
      std::find_if(table.begin(), table.end(), [](const TableColumn& column) { return column.name == "t"; });
  return static_cast<std::size_t>(time - table.begin());
}

bool has_samples(const std::vector<TableColumn>& table) {
  const std::vector<double>& trajectory = table.front().values;
  return std::adjacent_find(trajectory.begin(), trajectory.end()) != trajectory.end();
}

/// Trajectories over time; or what became of each, over the first of what varies.
const TableColumn& usual_across(const std::vector<TableColumn>& table) {
  if (!is_of_ensemble(table)) return table.front();
  const std::size_t time = place_of_time(table);
  if (time == table.size()) return table.front();
  return has_samples(table) || time == 2 ? table[time] : table[2];
}

std::vector<const TableColumn*> chosen(const std::vector<TableColumn>& table, const PlotOptions& options,
                                       const TableColumn& across) {
  std::vector<const TableColumn*> result;
  const auto take = [&](const TableColumn* column) {
    if (std::find(result.begin(), result.end(), column) == result.end()) result.push_back(column);
  };
  for (const std::string& name : options.columns) {
    for (const TableColumn* const column : named(table, name)) take(column);
  }
  if (!options.columns.empty()) return result;
  // Nobody has asked for time as a line.
  const std::size_t first = is_of_ensemble(table) ? std::min(place_of_time(table), table.size() - 1) + 1 : 1;
  for (std::size_t i = first; i < table.size(); ++i) {
    if (&table[i] != &across) take(&table[i]);
  }
  return result;
}

/// Of an instance, near.x, which has stopped before others.
bool ends_early(const TableColumn& column) {
  return column.name.find('.') != std::string::npos && !column.goes_on && std::isfinite(column.values.front());
}

void check_numbers(const TableColumn& column, bool may_have_gaps) {
  if (!column.no_number.empty()) throw cli::FileError(column.no_number);
  if (!may_have_gaps && !column.gap.empty() && !ends_early(column)) throw cli::FileError(column.gap);
}

}  // namespace

int draw_plot(const PlotOptions& options) {
  const std::vector<TableColumn> table = plot::read_table(options.file);
  check_names(table, options.columns, "--columns");
  if (!options.against.empty()) check_names(table, {options.against}, "--against");
  const TableColumn& across = options.against.empty() ? usual_across(table) : *named(table, options.against).front();
  const std::vector<const TableColumn*> columns = chosen(table, options, across);
  if (columns.empty()) throw cli::UsageError("the table has one column, and nothing to show against it");
  // Trajectories that did not arrive have no outputs.
  const bool is_ensemble = is_of_ensemble(table);
  check_numbers(across, is_ensemble);
  for (const TableColumn* const column : columns) check_numbers(*column, is_ensemble);
  plot::Bonds bonds;
  if (is_ensemble) bonds = {has_samples(table), &table.front()};
  const std::filesystem::path path(options.file);
  const std::string text = plot::chart(across, columns, path.stem().string(), bonds);
  const std::string output = !options.output.empty() ? options.output
                             : options.file == "-"   ? std::string("-")
                                                     : std::filesystem::path(path).replace_extension(".svg").string();
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
