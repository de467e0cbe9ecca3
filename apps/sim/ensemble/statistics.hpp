#pragma once
// What a set of numbers is like.

#include <array>
#include <vector>

namespace gausssim {

inline constexpr std::array<double, 5> k_shares{0.05, 0.25, 0.5, 0.75, 0.95};

struct Statistics {
  long count = 0;
  double mean = 0, deviation = 0;  ///< the latter with count - 1; 0 of one number
  double least = 0, most = 0;
  std::array<double, k_shares.size()>
      quantiles{};  ///< straight between order statistics, as R's type 7 and NumPy have them
};

/// Of finite numbers; the order in which they come may change the last digits of the mean.
Statistics statistics_of(std::vector<double> values);

}  // namespace gausssim
