#include "sim/effects/ladder_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/suggest.hpp"

namespace gausssim {

namespace {

constexpr std::size_t k_least_width = 22;

std::string row(const std::string& name, std::size_t width, const Measured& measured, bool has_change) {
  if (!measured.why.empty()) return fmt::format("  {:<{}}  {}\n", name, width, measured.why);
  std::string text = fmt::format("  {:<{}}  {:>10}  {:>9}  {:>9.4g}", name, width, measured.operations,
                                 measured.ns > 0 ? fmt::format("{:.3g}", measured.ns) : "-", 1e3 * measured.seconds);
  if (has_change && measured.change.output.empty())
    text += "  nothing";
  else if (has_change)
    text += fmt::format("  {:.1e} of {}", measured.change.value, measured.change.output);
  return text + "\n";
}

std::string head(const char* name, std::size_t width, const char* last) {
  return fmt::format("  {:<{}}  {:>10}  {:>9}  {:>9}  {}\n", name, width, "operations", "ns", "run [ms]", last);
}

std::size_t width_of(const EffectsReport& report) {
  std::size_t width = k_least_width;
  for (const auto& list : {report.ladder.each, report.ladder.rungs}) {
    for (const Compared& one : list) width = std::max(width, one.move.what.size());
  }
  return width;
}

}  // namespace

std::string in_words(const EffectsReport& report) {
  const auto& [bench, ladder, need, chosen] = report;
  const std::size_t width = width_of(report);
  std::string text = fmt::format(
      "{}: {:.6g} s by {} ({}), {}; effects {}\n\n", bench.name(), bench.duration(), bench.method(), bench.engine(),
      bench.noise() ? fmt::format("good to {:.1e}", bench.noise()->value) : "of an unknown error",
      gaussgen::support::joined(in_order(bench.all(), bench.effects())));
  text += head("what each costs", width, "changes the motion by");
  text += row("all", width, ladder.all, false);
  for (const Compared& one : ladder.each) text += row(one.move.what, width, one.measured, true);
  text += row("none", width, ladder.none, true);
  text += fmt::format("  {:<{}}  {:>10}\n", "shared by several", width, ladder.shared_operations());
  text += "\n" + head("left out in turn", width, "off by then");
  for (const Compared& one : ladder.rungs)
    text += row(one.move.what, width, one.measured, &one != &ladder.rungs.front());
  if (!need) return text;
  return text + fmt::format("\n  {:g} needs {}: {} of {} operations, {:.3g} of the time\n", *need,
                            gaussgen::support::joined(in_order(chosen->acting, bench.effects())), chosen->operations,
                            ladder.all.operations, ladder.all.seconds > 0 ? chosen->seconds / ladder.all.seconds : 1);
}

}  // namespace gausssim
