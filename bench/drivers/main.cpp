// driver KIND SIZE --check | --time ROUNDS MILLISECONDS | --run TOOL METRIC CALLS | --count
//
// Compares the contenders that are linked in, or measures them; a line of JSON for each. The first one is the measure of the others.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "cases.hpp"

namespace {

using namespace bench;

constexpr std::size_t k_most_speeds = 256;

struct Running {
  const Entry* entry;
  std::unique_ptr<Contender> contender;
  long calls = 0;
  std::vector<double> times = {};  ///< ns of one state
};

/// Of this thread alone: others share the machine.
double seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(Running& running) {
  const double begin = seconds();
  running.contender->run(running.calls);
  return seconds() - begin;
}

int check(std::vector<Running>& all) {
  bool is_right = true;
  for (Running& running : all) {
    double a[k_most_speeds], expected[k_most_speeds];
    double largest = 0;
    bool gives = true;
    for (std::size_t i = 0; i < k_states && gives; ++i) {
      std::fill_n(a, k_most_speeds, 0);
      std::fill_n(expected, k_most_speeds, 0);
      gives = running.contender->accelerations(i, a) && all.front().contender->accelerations(i, expected);
      double size = 0, difference = 0;
      for (std::size_t k = 0; k < k_most_speeds; ++k) {
        if (a[k] == k_not_given) continue;
        size = std::max(size, std::fabs(expected[k]));
        if (!(std::fabs(a[k] - expected[k]) <= difference)) difference = std::fabs(a[k] - expected[k]);
      }
      if (!(difference / size <= largest)) largest = difference / size;
    }
    if (!gives) continue;
    constexpr double k_most = 1e-9;
    if (running.entry->is_exact && !(largest <= k_most)) is_right = false;
    std::printf("{\"tool\": \"%s\", \"metric\": \"%s\", \"lanes\": %d, \"is_exact\": %s, \"difference\": %.3g}\n",
                running.entry->tool.c_str(), running.entry->metric.c_str(), running.entry->lanes,
                running.entry->is_exact ? "true" : "false", std::isfinite(largest) ? largest : 1e300);
  }
  return is_right ? 0 : 1;
}

double quantile(const std::vector<double>& sorted, double q) {
  return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1) + 0.5)];
}

/// Turn by turn, so that whatever else the machine does meets all of them; the first round warms up.
void time_all(std::vector<Running>& all, int rounds, double milliseconds) {
  for (Running& running : all) {
    running.calls = static_cast<long>(k_states);
    while (seconds_of(running) < 1e-3 * milliseconds) running.calls *= 2;
  }
  for (int round = 0; round < rounds; ++round) {
    for (Running& running : all)
      running.times.push_back(1e9 * seconds_of(running) / static_cast<double>(running.calls) / running.entry->lanes);
  }
  for (Running& running : all) {
    std::sort(running.times.begin(), running.times.end());
    std::printf(
        "{\"tool\": \"%s\", \"metric\": \"%s\", \"lanes\": %d, \"median\": %.5g, \"low\": %.5g, \"high\": %.5g}\n",
        running.entry->tool.c_str(), running.entry->metric.c_str(), running.entry->lanes, quantile(running.times, 0.5),
        quantile(running.times, 0.1), quantile(running.times, 0.9));
  }
}

void count(const std::vector<Running>& all) {
  for (const Running& running : all) {
    Operations found;
    if (!running.contender->count(found)) continue;
    std::printf("{\"tool\": \"%s\", \"metric\": \"%s\", \"operations\": %ld, \"functions\": %ld, \"divisions\": %ld}\n",
                running.entry->tool.c_str(), running.entry->metric.c_str(), found.all(), found.functions,
                found.divisions);
  }
}

bool is_before(const Entry* a, const Entry* b) {
  const auto rank = [](const Entry* entry) {
    const bool is_gauss = entry->tool.rfind("gauss", 0) == 0;
    return (entry->metric != "rhs" ? 4 : 0) + (entry->tool == "by hand" ? 0 : is_gauss ? 1 : 2);
  };
  return rank(a) != rank(b) ? rank(a) < rank(b) : a->tool < b->tool;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const std::string kind = argv[1], mode = argv[3];
  const int size = std::atoi(argv[2]);
  const Samples samples = samples_of(kind, size);
  std::vector<const Entry*> entries;
  for (const Entry& entry : registry()) {
    const bool is_wanted = mode != "--run" || (argc == 7 && entry.tool == argv[4] && entry.metric == argv[5]);
    if (is_wanted) entries.push_back(&entry);
  }
  std::stable_sort(entries.begin(), entries.end(), is_before);
  std::vector<Running> all;
  for (const Entry* entry : entries) {
    auto contender = entry->make(kind, size);
    if (!contender) continue;
    contender->take(samples);
    all.push_back({entry, std::move(contender)});
  }
  if (all.empty()) return 2;
  if (mode == "--check") return check(all);
  if (mode == "--time") return time_all(all, std::atoi(argv[4]), std::atof(argv[5])), 0;
  if (mode == "--count") return count(all), 0;
  if (mode == "--run") return all.front().contender->run(std::atol(argv[6])), 0;
  return 2;
}
