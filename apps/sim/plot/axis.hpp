#pragma once
// Numbers along an axis that people read well.

#include <string>
#include <vector>

namespace gausssim::plot {

struct Range {
  double least = 0, most = 0;
};

struct Tick {
  double value = 0;
  std::string label;
};

struct Axis {
  Range range;
  std::vector<Tick> ticks;
  double offset = 0;  ///< labels count from it
  int exponent = 0;   ///< and in powers of ten
};

/// Steps of 1, 2 or 5 times a power of ten, about `wanted` of them. Where numbers are large or small, labels leave a power of ten out; where they
/// change by little beside their size, they count from an offset.
/// `is_tight`: the axis ends where the range does.
Axis axis_of(Range range, int wanted, bool is_tight);

/// What labels leave out, for the title: `10⁻⁶ rad`, `from 4.905`; `unit` alone where they leave out nothing.
std::string unit_text(const Axis& axis, const std::string& unit);

}  // namespace gausssim::plot
