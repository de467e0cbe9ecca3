// Where a function of time falls through 0, between two times at which it and its rate are known.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_EVENT_CROSSING_HPP
#define GAUSS_EVENT_CROSSING_HPP

#include <algorithm>
#include <optional>

#include "gauss/event/dense.hpp"

namespace gauss::event {

/// Of a function at the ends of a step; rates are per step.
template <class S>
struct Ends {
  S begin, begin_rate, end, end_rate;

  /// Of the control points of the cubic (Bezier), between which it is.
  S least_control() const { return std::min({begin, end, S(begin + begin_rate / 3), S(end - end_rate / 3)}); }
  S largest_control() const { return std::max({begin, end, S(begin + begin_rate / 3), S(end - end_rate / 3)}); }

  /// The cubic through both (Hermite), at a part of the step.
  S operator()(const S& part) const {
    const S u = S(1) - part;
    return u * u * (begin * (S(1) + 2 * part) + begin_rate * part) +
           part * part * (end * (S(1) + 2 * u) - end_rate * u);
  }
};

/// The part of the step at which the cubic is least inside of it; nothing where that is at its ends.
template <class S>
std::optional<S> least_inside(const Ends<S>& ends) {
  // p' = a part² + b part + c
  const S rise = ends.end - ends.begin;
  const S a = 3 * (ends.begin_rate + ends.end_rate - 2 * rise);
  const S b = 2 * (3 * rise - 2 * ends.begin_rate - ends.end_rate), c = ends.begin_rate;
  const S square = b * b - 4 * a * c;
  if (square < S(0)) return std::nullopt;
  const S root = Math<S>::sqrt(square), q = (b < S(0) ? root - b : -root - b) / 2;
  for (const S& part : {a != S(0) ? S(q / a) : S(-1), q != S(0) ? S(c / q) : S(-1)}) {
    // A minimum: p'' = 2 a part + b > 0.
    if (S(0) < part && part < S(1) && 2 * a * part + b > S(0)) return part;
  }
  return std::nullopt;
}

/// Between `low`, where the function is positive, and `high`, where it is not: false position that never keeps one end for long (Illinois; Dowell and Jarratt,
/// BIT 11 (1971) 168-174), and halves where that is slow, as at roots of several folds. `value(t)` may take long. The result is a time at which it is not positive, as near to the root as times have digits, or as
/// its value tells.
template <class S, class Value>
S falls_through(S low, S low_value, S high, S high_value, const S& nearness, const Value& value) {
  constexpr int k_most = 100;
  constexpr int k_slow = 4;  ///< looks in which the interval ought to be halved
  int side = 0;
  S before = high - low;
  for (int k = 0; k < k_most && nearness < high - low && high_value < S(0); ++k) {
    S middle = high - high_value * ((high - low) / (high_value - low_value));
    if (k % k_slow == k_slow - 1) {
      if (2 * (high - low) > before) middle = low + (high - low) / 2;
      before = high - low;
    }
    if (!(low < middle && middle < high)) middle = low + (high - low) / 2;
    const S found = value(middle);
    if (!(found == found)) break;
    if (found > S(0)) {
      low = middle;
      low_value = found;
      if (side == 1) high_value = high_value / 2;
      side = 1;
    } else {
      high = middle;
      high_value = found;
      if (side == -1) low_value = low_value / 2;
      side = -1;
    }
  }
  return high;
}

}  // namespace gauss::event

#endif  // GAUSS_EVENT_CROSSING_HPP
