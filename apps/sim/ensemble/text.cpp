#include <fmt/format.h>

#include <algorithm>

#include "sim/ensemble/summary.hpp"

namespace gausssim {

namespace {

/// Widest of the names that stand in one column.
std::size_t width_of_names(const EnsembleTold& told) {
  std::size_t width = 0;
  for (const Column& column : told.prepared.columns.columns)
    width = std::max(width, column.name.size() + column.unit.size() + 3);
  return width;
}

std::string table_of_outputs(const EnsembleTold& told) {
  const std::size_t width = width_of_names(told);
  std::string text = fmt::format("  {:<{}}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "at the end", width, "mean", "deviation",
                                 "least", "median", "most");
  for (std::size_t k = 0; k < told.statistics.size(); ++k) {
    const Column& column = told.prepared.columns.columns[k];
    const Statistics& one = told.statistics[k];
    const std::string name = column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
    if (one.count == 0) {
      text += fmt::format("  {:<{}}{:>12}\n", name, width, "none");
      continue;
    }
    text += fmt::format("  {:<{}}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}\n", name, width, one.mean, one.deviation,
                        one.least, one.quantiles[k_shares.size() / 2], one.most);
  }
  return text;
}

std::string seconds_in_words(const EnsembleTold& told) {
  const double compiled = told.times.compile + told.lanes_seconds;
  const std::string also = compiled > 0 ? fmt::format("; compiled in {:.3g} s", compiled) : "";
  return fmt::format("  {:.3g} s: {:.4g} trajectories/s, {:.4g} steps/s{}\n", told.outcomes.wall_seconds,
                     rate_of(told.outcomes.run(), told.outcomes), rate_of(told.outcomes.steps(), told.outcomes), also);
}

/// What gives lanes up takes the time of both.
std::string left_in_words(const EnsembleTold& told) {
  const long left = told.setting.lanes == nullptr ? 0 : told.outcomes.left_lane();
  constexpr long k_few = 10;  ///< one of so many
  if (left == 0) return "";
  return fmt::format("  {:8} left their lanes and ran alone{}\n", left,
                     k_few * left > told.outcomes.run() ? ": --lanes 1 may take less time" : "");
}

std::string counted(int count, const char* what) { return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"); }

}  // namespace

std::string ensemble_text(const EnsembleTold& told) {
  const EnsembleSetting& setting = told.setting;
  std::string text = fmt::format("{}: {} trajectories by {} ({}, {}, {})\n", told.prepared.name(), told.outcomes.run(),
                                 setting.setting.method, setting.setting.number,
                                 counted(setting.lanes == nullptr ? 1 : setting.lanes->lanes(), "lane"),
                                 counted(setting.threads, "thread"));
  for (const auto& [status, count] : counts_by_status(told.outcomes)) text += fmt::format("  {:8} {}\n", count, status);
  return text + left_in_words(told) + table_of_outputs(told) + seconds_in_words(told);
}

}  // namespace gausssim
