#include "support/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace gaussgen::support {

namespace {

constexpr std::size_t k_longest_name = 64;

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Insertions, deletions, replacements and swaps of neighbours; a change of case alone counts half.
/// Costs are doubled so that they stay whole.
int edit_cost(std::string_view a, std::string_view b) {
  std::vector<int> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(2 * j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(2 * i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = a[i - 1] == b[j - 1] ? 0 : lower(a[i - 1]) == lower(b[j - 1]) ? 1 : 2;
      row[j] = std::min({last[j] + 2, row[j - 1] + 2, last[j - 1] + replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 2);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

std::string closest(std::string_view name, const std::vector<std::string>& candidates) {
  if (name.empty() || name.size() > k_longest_name) return {};
  std::string best;
  int best_cost = static_cast<int>(2 * std::max<std::size_t>(1, name.size() / 3)) + 1;
  for (const std::string& candidate : candidates) {
    // A one-letter name is one edit away from every other: only a change of case is a slip there.
    const int limit = candidate.size() == 1 && name.size() == 1 ? 2 : best_cost;
    const int cost = edit_cost(name, candidate);
    if (cost < std::min(limit, best_cost)) {
      best = candidate;
      best_cost = cost;
    }
  }
  return best;
}

std::string closest_or_begun(std::string_view name, const std::vector<std::string>& candidates) {
  constexpr std::size_t k_shortest = 3;
  std::string best;
  for (const std::string& candidate : candidates) {
    const bool is_begun = name.size() >= k_shortest && candidate.compare(0, name.size(), name) == 0;
    if (is_begun && (best.empty() || candidate.size() < best.size())) best = candidate;
  }
  return best.empty() ? closest(name, candidates) : best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string best = closest(name, candidates);
  return best.empty() ? std::string() : "did you mean '" + best + "'?";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string joined_first(const std::vector<std::string>& words) {
  constexpr std::size_t k_most = 12;
  if (words.size() <= k_most) return joined(words);
  return joined({words.begin(), words.begin() + k_most}) + " and " + std::to_string(words.size() - k_most) + " more";
}

}  // namespace gaussgen::support
