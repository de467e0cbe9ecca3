#include "cli/timings.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <map>

namespace gaussgen::cli {

namespace {

long long whole(std::size_t number) { return static_cast<long long>(number); }

std::string text_of(std::size_t bytes) { return bytes == 0 ? "" : fmt::format("  {} bytes of text", bytes); }

/// Of a table; what is a number stands to the right.
std::string row(const std::string& name, const std::string& milliseconds, const std::string& before,
                const std::string& after, const std::string& rest = "") {
  return fmt::format("{:<12} {:>10} {:>12} {:>12}{}", name, milliseconds, before, after, rest);
}

std::string row(const std::string& name, double milliseconds, std::size_t before, std::size_t after,
                const std::string& rest) {
  return row(name, fmt::format("{:.3f}", milliseconds), fmt::format("{}", before), fmt::format("{}", after), rest);
}

void print_stages(const std::vector<StageTime>& stages, const MessageOptions& messages) {
  if (messages.format == MessageFormat::text) remark(row("stage", "ms", "nodes in", "nodes out"), messages);
  double total = 0;
  for (const StageTime& stage : stages) {
    remark(row(stage.stage, stage.milliseconds, stage.nodes_in, stage.nodes_out, text_of(stage.bytes)),
           {{"stage", stage.stage},
            {"milliseconds", stage.milliseconds},
            {"nodes_in", whole(stage.nodes_in)},
            {"nodes_out", whole(stage.nodes_out)},
            {"bytes", whole(stage.bytes)}},
           messages);
    total += stage.milliseconds;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);  // kilobytes on Linux, which is where there is a package
  const long long peak = 1024LL * usage.ru_maxrss;
  remark(row("total", fmt::format("{:.3f}", total), "", "",
             fmt::format("  {:.1f} MB at most", 1e-6 * static_cast<double>(peak))),
         {{"stage", "total"}, {"milliseconds", total}, {"peak_bytes", peak}}, messages);
}

/// A pass over all functions: it may run more than once, and each time counts for itself. Functions that take different orders of passes
/// have different rows.
struct PassSum {
  std::string name;
  int run = 0;  ///< of this pass, in its function
  double milliseconds = 0;
  int before = 0;
  int after = 0;
};

std::vector<PassSum> sums_of(const std::vector<emit::PassEffects>& functions) {
  std::vector<PassSum> sums;
  for (const emit::PassEffects& function : functions) {
    std::map<std::string, int> runs;
    std::size_t next = 0;  // what is new stands behind the pass before it
    for (const passes::PassEffect& pass : function.passes) {
      const int run = runs[pass.pass]++;
      auto sum = std::find_if(sums.begin(), sums.end(),
                              [&](const PassSum& known) { return known.name == pass.pass && known.run == run; });
      if (sum == sums.end()) sum = sums.insert(sums.begin() + static_cast<std::ptrdiff_t>(next), {pass.pass, run});
      sum->milliseconds += pass.milliseconds;
      sum->before += pass.before;
      sum->after += pass.after;
      next = static_cast<std::size_t>(sum - sums.begin()) + 1;
    }
  }
  return sums;
}

std::string saved(int before, int after) { return fmt::format(" {:>8}", before - after); }

// For people, passes over all functions and functions over all passes: each with each is what programs get.
void print_pass_tables(const std::vector<emit::PassEffects>& functions, const MessageOptions& messages) {
  remark(row("pass", "ms", "operations", "after it", fmt::format(" {:>8}", "saved")), messages);
  for (const PassSum& sum : sums_of(functions)) {
    remark(row(sum.name, fmt::format("{:.3f}", sum.milliseconds), fmt::format("{}", sum.before),
               fmt::format("{}", sum.after), saved(sum.before, sum.after)),
           messages);
  }
  remark(fmt::format("{:<23} {:>12} {:>12} {:>8}", "function", "operations", "after all", "saved"), messages);
  for (const emit::PassEffects& function : functions) {
    if (function.passes.empty()) continue;
    const int before = function.passes.front().before;
    const int after = function.passes.back().after;
    remark(fmt::format("{:<23} {:>12} {:>12}{}", function.function, before, after, saved(before, after)), messages);
  }
}

void print_passes_as_facts(const std::vector<emit::PassEffects>& functions, const MessageOptions& messages) {
  for (const emit::PassEffects& function : functions) {
    for (const passes::PassEffect& pass : function.passes) {
      remark(fmt::format("{}: {} operations, {} after {}", function.function, pass.before, pass.after, pass.pass),
             {{"function", function.function},
              {"pass", pass.pass},
              {"milliseconds", pass.milliseconds},
              {"operations_before", static_cast<long long>(pass.before)},
              {"operations_after", static_cast<long long>(pass.after)}},
             messages);
    }
  }
}

}  // namespace

void print_timings(const PipelineResult& result, const MessageOptions& messages) {
  print_stages(result.times, messages);
  const bool has_passes = std::any_of(result.passes.begin(), result.passes.end(),
                                      [](const emit::PassEffects& function) { return !function.passes.empty(); });
  if (!has_passes) return;
  if (messages.format == MessageFormat::json) return print_passes_as_facts(result.passes, messages);
  print_pass_tables(result.passes, messages);
}

}  // namespace gaussgen::cli
