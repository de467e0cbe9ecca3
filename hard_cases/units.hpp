#pragma once
// Systems of units for H31, in which numbers are 1e9 times as large or as small.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "case.hpp"
#include "gauss/model_concept.hpp"

namespace hard_cases {

/// Binary exponents of what numbers in m, kg and s are multiplied by.
struct Units {
  int length, mass, time;
};

/// Alone, together, and nanometres beside tonnes.
inline constexpr Units k_units[] = {{30, 0, 0},  {-30, 0, 0},   {0, 30, 0},      {0, -30, 0},   {0, 0, 30},
                                    {0, 0, -30}, {30, 30, -30}, {-30, -30, -30}, {-30, 30, 30}, {30, -10, 0}};

/// Of one factor of a unit, as "s^2".
inline int exponent_of_factor(std::string_view factor, const Units& units) {
  int power = 1;
  if (const std::size_t hat = factor.find('^'); hat != std::string_view::npos) {
    power = factor[hat + 1] - '0';
    factor = factor.substr(0, hat);
  }
  if (factor == "m") return power * units.length;
  if (factor == "kg") return power * units.mass;
  if (factor == "s") return power * units.time;
  if (factor == "N") return power * (units.mass + units.length - 2 * units.time);
  return 0;  // rad, 1
}

/// What a value with this unit is multiplied by.
inline double factor(std::string_view unit, const Units& units) {
  int exponent = 0, sign = 1;
  while (!unit.empty()) {
    const std::size_t end = unit.find_first_of("*/");
    exponent += sign * exponent_of_factor(unit.substr(0, end), units);
    if (end == std::string_view::npos) break;
    sign = unit[end] == '/' ? -1 : 1;
    unit.remove_prefix(end + 1);
  }
  return std::ldexp(1.0, exponent);
}

/// How results differ from those in m, kg and s.
struct Change {
  double largest = 0;  ///< relative to the largest of a result
  double naive = 0;    ///< the same of a naive form
  double statuses = 0;

  void compare(const double* base, const double* other, int count) { grow(largest, change(base, other, count)); }
  void compare_naive(const double* base, const double* other, int count) { grow(naive, change(base, other, count)); }
  void compare(gauss::Status base, gauss::Status other) { statuses += base == other ? 0 : 1; }

 private:
  static double change(const double* base, const double* other, int count) {
    double size = 0, result = 0;
    for (int i = 0; i < count; ++i) size = std::max(size, std::abs(base[i]));
    for (int i = 0; i < count; ++i) grow(result, size == 0 ? other[i] : (other[i] - base[i]) / size);
    return result;
  }
};

}  // namespace hard_cases
