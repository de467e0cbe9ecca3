#pragma once
// Values that differ by their rounding: what all runs in one number type have in common, and none of them sees.

#include <cmath>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/drive/numbers.hpp"
#include "sim/drive/quad.hpp"
#include "sim/output/csv.hpp"

namespace gausssim {

/// The shortest decimal of a value, in a type that holds more of it: what somebody wrote, if it has no more digits than the type.
inline double as_written(float value) { return std::strtod(text_of(value).c_str(), nullptr); }
inline long double as_written(double value) { return std::strtold(text_of(value).c_str(), nullptr); }
inline Quad as_written(long double value) { return quad_of(text_of(value)); }

/// Each by `unit` of its size, towards what somebody wrote; what is as it was written stays. Nothing is wider than Quad: there, all of them.
template <class S>
void nudge_given(std::vector<S>& values, const S& unit) {
  for (S& value : values) {
    const S size = (value < S(0) ? -value : value) * unit;
    if constexpr (std::is_same_v<S, Quad>) {
      value += size;
    } else {
      const auto written = as_written(value);
      if (written != value) value += written > value ? size : -size;
    }
  }
}

/// Each by `unit` of its size, up and down by turns: also what steps round as they are taken.
template <class S>
void nudge_state(Numbers<S>& values, const S& unit) {
  S by = unit;
  for (S& value : values) {
    value += value * by;
    by = -by;
  }
}

}  // namespace gausssim
