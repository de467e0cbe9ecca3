#pragma once
// What is measured against: the same emitted functions with 100 digits.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "case.hpp"

namespace hard_cases {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// Largest difference of `count` values over the largest of them; what is not a number breaks down.
inline double relative_error(const double* found, const Wide* exact, int count) {
  Wide largest = 0, size = 0;
  for (int i = 0; i < count; ++i) {
    const Wide difference = abs(Wide(exact[i] - found[i])), own = abs(exact[i]);
    if (difference != difference) return k_breaks_down;
    if (difference > largest) largest = difference;
    if (own > size) size = own;
  }
  const Wide relative = largest / size;
  return static_cast<double>(relative);
}

}  // namespace hard_cases
