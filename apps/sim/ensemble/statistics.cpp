#include "sim/ensemble/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace gausssim {

namespace {

double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

}  // namespace

Statistics statistics_of(std::vector<double> values) {
  Statistics result;
  result.count = static_cast<long>(values.size());
  if (values.empty()) return result;
  // Means that follow the numbers (Welford 1962) do not lose the digits of small deviations.
  double squares = 0, seen = 0;
  for (const double value : values) {
    const double off = value - result.mean;
    result.mean += off / ++seen;
    squares += off * (value - result.mean);
  }
  result.deviation = values.size() < 2 ? 0 : std::sqrt(squares / (seen - 1));
  std::sort(values.begin(), values.end());
  result.least = values.front();
  result.most = values.back();
  for (std::size_t k = 0; k < k_shares.size(); ++k) result.quantiles[k] = quantile(values, k_shares[k]);
  return result;
}

}  // namespace gausssim
