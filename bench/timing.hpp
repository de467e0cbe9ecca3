#pragma once
// Medians of repeated measurements.

#include <algorithm>
#include <chrono>
#include <vector>

namespace bench {

struct Times {
  double median = 0;
  double fastest = 0;
};

inline Times summary(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times.front()};
}

/// Seconds of one call.
template <class F>
double seconds(F&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Two works by turns, so that whatever else the machine does meets both; the first pair warms up.
template <class F, class G>
std::pair<Times, Times> by_turns(int batches, F&& one, G&& other) {
  std::vector<double> first, second;
  for (int i = 0; i <= batches; ++i) {
    const double a = seconds(one);
    const double b = seconds(other);
    if (i == 0) continue;
    first.push_back(a);
    second.push_back(b);
  }
  return {summary(first), summary(second)};
}

}  // namespace bench
